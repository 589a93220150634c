#include "vtkVarimarchFloatPass.h"

#include "VtkVersions.h"

#include "vtkBoundingBox.h"
#include "vtkCommunicator.h"
#include "vtkIceTCompositePass.h"
#include "vtkIceTContext.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVLogger.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <IceT.h>

#include <algorithm>
#include <array>
#include <utility>

namespace
{

// A prop that has bounds and draws nothing.
class BoundsOnly : public vtkProp
{
public:
  static BoundsOnly* New();
  vtkTypeMacro(BoundsOnly, vtkProp);
  double* GetBounds() override { return this->Bounds.data(); }

  std::array<double, 6> Bounds{};

protected:
  BoundsOnly() { this->PickableOff(); }
};
vtkStandardNewMacro(BoundsOnly);

// The bounds of what is visible on any process.
std::array<double, 6> CommonBoundsOf(vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  vtkBoundingBox own;
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  own.AddBounds(bounds);
  // The least of the lower bounds and of the negative upper ones.
  const double* const lower = own.GetMinPoint();
  const double* const upper = own.GetMaxPoint();
  const double least[] = { lower[0], -upper[0], lower[1], -upper[1], lower[2], -upper[2] };
  std::array<double, 6> common;
  controller->AllReduce(least, common.data(), 6, vtkCommunicator::MIN_OP);
  for (int axis = 0; axis < 3; ++axis)
  {
    common[2 * axis + 1] = -common[2 * axis + 1];
  }
  return common;
}

// Makes a context of IceT the current one, and the previous one again in the end.
class CurrentContext
{
public:
  explicit CurrentContext(vtkIceTContext* context)
    : previous(icetGetContext())
  {
    context->MakeCurrent();
  }
  ~CurrentContext() { icetSetContext(this->previous); }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

private:
  IceTContext previous;
};

// Logs times of IceT's current context under names like those of ParaView's own compositing.
void LogTimes(double renderSeconds)
{
  constexpr std::pair<const char*, IceTEnum> Times[] = { { "COMPOSITE", ICET_COMPOSITE_TIME },
    { "BLEND", ICET_BLEND_TIME }, { "COMPRESS", ICET_COMPRESS_TIME },
    { "COLLECT", ICET_COLLECT_TIME } };
  vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "VARIMARCH_RENDER_TIME: %lf", renderSeconds);
  for (const auto& [name, parameter] : Times)
  {
    IceTDouble seconds = 0.0;
    icetGetDoublev(parameter, &seconds);
    vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "VARIMARCH_%s_TIME: %lf", name, seconds);
  }
}

}

vtkStandardNewMacro(vtkVarimarchFloatPass);

vtkVarimarchFloatPass::vtkVarimarchFloatPass() = default;

vtkVarimarchFloatPass::~vtkVarimarchFloatPass()
{
  this->End();
}

void vtkVarimarchFloatPass::Begin(vtkRenderer* renderer, vtkIceTCompositePass* compositePass,
  vtkMultiProcessController* controller, std::vector<int> order)
{
  this->Context->SetController(controller);
  this->Order = std::move(order);
  this->Renderer = renderer;
  this->CompositePass = compositePass;
  this->OwnPass = compositePass->GetRenderPass();
  compositePass->SetRenderPass(this);
  compositePass->SetRenderEmptyImages(true);
  const auto common = vtkSmartPointer<BoundsOnly>::New();
  common->Bounds = CommonBoundsOf(renderer, controller);
  this->CommonBounds = common;
  renderer->AddViewProp(common);
}

void vtkVarimarchFloatPass::End()
{
  if (this->Renderer && this->CommonBounds)
  {
    this->Renderer->RemoveViewProp(this->CommonBounds);
  }
  if (this->CompositePass && this->OwnPass)
  {
    this->CompositePass->SetRenderPass(this->OwnPass);
  }
  this->CommonBounds = nullptr;
  this->OwnPass = nullptr;
}

void vtkVarimarchFloatPass::Render(const vtkRenderState* state)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  const int size[] = { window->GetActualSize()[0], window->GetActualSize()[1] };
  std::vector<float> pixels(4 * std::size_t(size[0]) * size[1]);
  vtkOpenGLState* const glState = window->GetState();
  glState->PushFramebufferBindings();
  this->Bind(window, size);
  const double begin = icetWallTime();
  this->OwnPass->Render(state);
  glState->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_FLOAT, pixels.data());
  const double renderSeconds = icetWallTime() - begin;
  glState->PopFramebufferBindings();
  {
    const CurrentContext current(this->Context);
    pixels = this->Composite(pixels, size);
    LogTimes(renderSeconds);
  }
  if (!pixels.empty())
  {
    const vtkOpenGLState::ScopedglEnableDisable blend(glState, GL_BLEND);
    const vtkOpenGLState::ScopedglViewport viewport(glState);
    glState->vtkglDisable(GL_BLEND);
    glState->vtkglViewport(0, 0, size[0], size[1]);
    window->DrawPixels(size[0], size[1], 4, VTK_FLOAT, pixels.data());
  }
}

// Binds and clears the framebuffer. Like the window's own, it limits colours to [0, 1] before they
// are blended, which one of floats does not. Its depths have the format of those of VTK's
// framebuffers, from which mappers copy them.
void vtkVarimarchFloatPass::Bind(vtkOpenGLRenderWindow* window, const int size[2])
{
  constexpr int DepthBits = 32;
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  if (this->Framebuffer->GetNumberOfColorAttachments() == 0 ||
    !std::equal(size, size + 2, this->FramebufferSize))
  {
    this->Framebuffer->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_SHORT, true,
      DepthBits, 0, window->GetStencilCapable() != 0);
    std::copy_n(size, 2, this->FramebufferSize);
  }
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
  vtkOpenGLState* const state = window->GetState();
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// Composites the pictures of all processes in the current context of IceT.
// @return  the pixels on the process that shows the image; empty on others
std::vector<float> vtkVarimarchFloatPass::Composite(
  const std::vector<float>& own, const int size[2])
{
  constexpr int Shower = 0;
  constexpr IceTDouble Identity[] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  constexpr IceTFloat Background[4] = {};
  icetResetTiles();
  icetAddTile(0, 0, size[0], size[1], Shower);
  icetPhysicalRenderSize(size[0], size[1]);
  icetStrategy(ICET_STRATEGY_SEQUENTIAL);
  icetSetColorFormat(ICET_IMAGE_COLOR_RGBA_FLOAT);
  icetSetDepthFormat(ICET_IMAGE_DEPTH_NONE);
  icetCompositeMode(ICET_COMPOSITE_MODE_BLEND);
  icetEnable(ICET_ORDERED_COMPOSITE);
  icetCompositeOrder(this->Order.data());
  const IceTImage image =
    icetCompositeImage(own.data(), nullptr, nullptr, Identity, Identity, Background);
  if (this->Context->GetController()->GetLocalProcessId() != Shower)
  {
    return {};
  }
  const IceTFloat* const colors = icetImageGetColorcf(image);
  return std::vector<float>(colors, colors + 4 * icetImageGetNumPixels(image));
}

void vtkVarimarchFloatPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->OwnPass)
  {
    this->OwnPass->ReleaseGraphicsResources(window);
  }
}
