#include "Scene/FloatCapture.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRect.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <stdexcept>

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

// Some drivers stop a single draw call that takes seconds, and progress cannot be reported during
// one.
void RenderInBands(
  vtkRenderer* renderer, const int size[2], const std::function<void(double)>& onBand)
{
  constexpr int BandRows = 16;
  for (int row = 0; row < size[1]; row += BandRows)
  {
    onBand(double(row) / size[1]);
    // The camera resets its scissor rectangle after each frame.
    renderer->GetActiveCamera()->SetScissorRect(
      vtkRecti(0, row, size[0], std::min(BandRows, size[1] - row)));
    renderer->GetActiveCamera()->SetUseScissor(true);
    renderer->Render();
    glFinish();
  }
}

}

vtkSmartPointer<vtkImageData> CaptureFloatImage(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const std::function<void(double)>& onBand)
{
  // Start() creates the context if necessary, sets the state that VTK's classes rely on, and binds
  // the window's framebuffer, which ours then replaces.
  window->Start();
  const int* size = window->GetSize();
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  framebuffer->SetContext(window);
  const bool complete =
    framebuffer->PopulateFramebuffer(size[0], size[1], true, 1, VTK_FLOAT, true, 24, 0, false);

  auto image = vtkSmartPointer<vtkImageData>::New();
  if (complete)
  {
    const WithoutBackground withoutBackground(renderer);
    onBand ? RenderInBands(renderer, size, onBand) : renderer->Render();
    image->SetDimensions(size[0], size[1], 1);
    image->AllocateScalars(VTK_FLOAT, 4);
    framebuffer->Bind();
    window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_FLOAT, image->GetScalarPointer());
  }
  window->End();
  if (!complete)
  {
    throw std::runtime_error("OpenGL has no framebuffer of 32-bit floats for " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels");
  }
  return image;
}

}
