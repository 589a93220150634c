#include "Scene/Images/FloatCapture.h"

#include "VtkVersions.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRect.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace varimarch
{

namespace
{

// Removes a renderer's background for the lifetime of this object.
class WithoutBackground
{
public:
  explicit WithoutBackground(vtkRenderer* renderer)
    : renderer(renderer)
    , alpha(renderer->GetBackgroundAlpha())
  {
    renderer->GetBackground(this->rgb.data());
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->SetBackgroundAlpha(0.0);
  }

  ~WithoutBackground()
  {
    this->renderer->SetBackground(this->rgb.data());
    this->renderer->SetBackgroundAlpha(this->alpha);
  }

private:
  vtkRenderer* renderer;
  std::array<double, 3> rgb;
  double alpha;
};

// The use of a window, in which a framebuffer replaces its own.
class WindowInUse
{
public:
  // Start() creates the context if necessary, sets the state that VTK's classes rely on, and binds
  // the window's framebuffer.
  explicit WindowInUse(vtkOpenGLRenderWindow* window)
    : window(window)
  {
    window->Start();
  }
  ~WindowInUse() { this->window->End(); }
  WindowInUse(const WindowInUse&) = delete;
  WindowInUse& operator=(const WindowInUse&) = delete;

private:
  vtkOpenGLRenderWindow* window;
};

}

FloatCapture::FloatCapture(vtkOpenGLRenderWindow* window, vtkRenderer* renderer)
  : window(window)
  , renderer(renderer)
{
  const WindowInUse use(window);
  std::copy_n(window->GetSize(), 2, this->size.begin());
  this->framebuffer->SetContext(window);
  // VTK's mapper copies the depths of geometry, for which OpenGL requires the format of VTK's own
  // framebuffers.
  constexpr int DepthBits = 32;
  const bool hasStencil = window->GetStencilCapable() != 0;
  if (!this->framebuffer->PopulateFramebuffer(
        this->size[0], this->size[1], true, 1, VTK_FLOAT, true, DepthBits, 0, hasStencil))
  {
    throw std::runtime_error("OpenGL has no framebuffer of 32-bit floats for " +
      std::to_string(this->size[0]) + " x " + std::to_string(this->size[1]) + " pixels");
  }
}

void FloatCapture::RenderRows(int count)
{
  const WindowInUse use(this->window);
  const WithoutBackground withoutBackground(this->renderer);
  this->framebuffer->Bind();
  count = std::min(count, this->RowsLeft());
  if (count < this->size[1])
  {
    // The camera resets its scissor rectangle after each frame.
    vtkCamera* const camera = this->renderer->GetActiveCamera();
    camera->SetScissorRect(vtkRecti(0, this->rowsDone, this->size[0], count));
    camera->SetUseScissor(true);
  }
  this->renderer->Render();
  glFinish();
  this->rowsDone += count;
}

vtkSmartPointer<vtkImageData> FloatCapture::Image()
{
  const WindowInUse use(this->window);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->size[0], this->size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  this->framebuffer->Bind();
  this->window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, this->size[0], this->size[1], GL_RGBA, GL_FLOAT, image->GetScalarPointer());
  return image;
}

vtkSmartPointer<vtkImageData> CaptureFloatImage(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const std::function<bool(double)>& onBand)
{
  constexpr int BandRows = 16;
  FloatCapture capture(window, renderer);
  if (!onBand)
  {
    capture.RenderRows(capture.RowsLeft());
    return capture.Image();
  }
  bool goesOn = true;
  const auto ask = [&] { return goesOn = goesOn && onBand(capture.PartDone()); };
  const StopCheck check(window, ask);
  while (capture.RowsLeft() > 0 && ask())
  {
    capture.RenderRows(BandRows);
  }
  return goesOn ? capture.Image() : nullptr;
}

StopCheck::StopCheck(vtkRenderWindow* window, std::function<bool()> isWanted)
  : window(window)
  , isWanted(std::move(isWanted))
{
  this->command->SetClientData(this);
  this->command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<StopCheck*>(self)->Check(); });
  window->SetAbortRender(0);
  window->AddObserver(vtkCommand::AbortCheckEvent, this->command);
}

StopCheck::~StopCheck()
{
  this->window->RemoveObserver(this->command);
  this->window->SetAbortRender(0);
}

void StopCheck::Check()
{
  if (!this->isWanted())
  {
    this->window->SetAbortRender(1);
  }
  this->window->MakeCurrent();
}

}
