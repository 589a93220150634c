#include "vtkVarimarchFloatPass.h"

#include "VtkVersions.h"

#include "vtkBoundingBox.h"
#include "vtkCameraPass.h"
#include "vtkCommunicator.h"
#include "vtkFrameBufferObjectBase.h"
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
#include "vtkTextureObject.h"

#include <IceT.h>

#include <algorithm>
#include <array>
#include <fstream>
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

// The size of the framebuffer into which a pass is to draw: that of another pass, or the window's.
std::array<int, 2> SizeOf(const vtkRenderState* state)
{
  std::array<int, 2> size;
  if (vtkFrameBufferObjectBase* const framebuffer = state->GetFrameBuffer())
  {
    framebuffer->GetLastSize(size.data());
    return size;
  }
  std::copy_n(state->GetRenderer()->GetRenderWindow()->GetActualSize(), 2, size.begin());
  return size;
}

// The pixels of the framebuffer that is bound.
std::vector<float> BoundPixels(vtkOpenGLState* state, const std::array<int, 2>& size)
{
  std::vector<float> pixels(4 * std::size_t(size[0]) * size[1]);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

// Shows pixels in the framebuffer that is bound, and nothing of what it has.
void Show(vtkOpenGLRenderWindow* window, std::vector<float>& pixels, const std::array<int, 2>& size)
{
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglViewport(0, 0, size[0], size[1]);
  window->DrawPixels(size[0], size[1], 4, VTK_FLOAT, pixels.data());
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

void vtkVarimarchFloatPass::BeginAlone(vtkCameraPass* cameraPass)
{
  this->CameraPass = cameraPass;
  this->OwnPass = cameraPass->GetDelegatePass();
  cameraPass->SetDelegatePass(this);
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
  if (this->CameraPass && this->OwnPass)
  {
    this->CameraPass->SetDelegatePass(this->OwnPass);
  }
  this->CompositePass = nullptr;
  this->CameraPass = nullptr;
  this->CommonBounds = nullptr;
  this->OwnPass = nullptr;
}

void vtkVarimarchFloatPass::Render(const vtkRenderState* state)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow());
  const std::array<int, 2> size = SizeOf(state);
  std::vector<float> pixels;
  window->GetState()->PushFramebufferBindings();
  this->Bind(window, size.data());
  const double begin = icetWallTime();
  this->OwnPass->Render(state);
  if (this->CompositePass || !this->ImageFile.empty())
  {
    pixels = BoundPixels(window->GetState(), size);
  }
  const double renderSeconds = icetWallTime() - begin;
  window->GetState()->PopFramebufferBindings();
  if (!this->CompositePass)
  {
    this->ShowOverBackground(window, size.data());
  }
  else
  {
    const CurrentContext current(this->Context);
    pixels = this->Composite(pixels, size.data());
    LogTimes(renderSeconds);
    if (!pixels.empty())
    {
      Show(window, pixels, size);
    }
  }
  // A texture keeps the program that shows it, which fails once ParaView has closed another view.
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->WriteImage(pixels);
}

// Binds and clears the framebuffer. It does not limit colours to 1: the light of a part may exceed
// it, before another is laid over it. Its depths have the format of those of VTK's framebuffers,
// from which mappers copy them.
void vtkVarimarchFloatPass::Bind(vtkOpenGLRenderWindow* window, const int size[2])
{
  constexpr int DepthBits = 32;
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->PopulateFramebuffer(
    size[0], size[1], true, 1, VTK_FLOAT, true, DepthBits, 0, window->GetStencilCapable() != 0);
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

// Lays the own framebuffer over the one that is bound, and gives that its depths.
void vtkVarimarchFloatPass::ShowOverBackground(vtkOpenGLRenderWindow* window, const int size[2])
{
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  const vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglViewport(0, 0, size[0], size[1]);
  this->Framebuffer->GetColorAttachmentAsTextureObject(0)->CopyToFrameBuffer(nullptr, nullptr);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  window->TextureDepthBlit(this->Framebuffer->GetDepthAttachmentAsTextureObject());
}

void vtkVarimarchFloatPass::WriteImage(const std::vector<float>& pixels)
{
  if (this->ImageFile.empty() || pixels.empty())
  {
    return;
  }
  std::ofstream file(this->ImageFile, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(pixels.data()), std::streamsize(pixels.size() * sizeof(float)));
  if (!file.flush())
  {
    vtkErrorMacro(<< "Cannot write the image as floats: the file " << this->ImageFile
                  << " cannot be written.");
  }
}

void vtkVarimarchFloatPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->OwnPass)
  {
    this->OwnPass->ReleaseGraphicsResources(window);
  }
}
