#ifndef Varimarch_Scene_FloatCapture_h
#define Varimarch_Scene_FloatCapture_h

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>

class vtkCallbackCommand;
class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderer;

namespace varimarch
{

/// Renders once into a framebuffer of 32-bit floats that starts out transparent, some rows at a
/// time, with pauses as long as the scene does not change. Some drivers stop a single draw call
/// that takes seconds, and a window does not react during one.
class FloatCapture
{
public:
  /// @param window  the renderer's window, of the size to render; both must outlive this object
  /// @throws std::runtime_error if the driver does not support such a framebuffer
  FloatCapture(vtkOpenGLRenderWindow* window, vtkRenderer* renderer);

  /// Renders the next rows, from the bottom up, and waits for them.
  void RenderRows(int count);
  int RowsLeft() const { return this->size[1] - this->rowsDone; }
  double PartDone() const { return double(this->rowsDone) / this->size[1]; } ///< [0, 1]

  /// Premultiplied RGBA without the background and without rounding to 8 bits, the bottom row
  /// first. Errors are measured on such images. Requires that no rows are left.
  vtkSmartPointer<vtkImageData> Image();

private:
  vtkOpenGLRenderWindow* window;
  vtkRenderer* renderer;
  std::array<int, 2> size;
  int rowsDone = 0;
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
};

/// The whole image.
/// @param onBand  if given, the image is rendered in horizontal bands, and this is called before
///                each one, and while steps are searched for, with the fraction done, [0, 1); for
///                images that take long. It returns false to cancel.
/// @return null if cancelled
/// @throws std::runtime_error if the driver does not support such a framebuffer
vtkSmartPointer<vtkImageData> CaptureFloatImage(vtkOpenGLRenderWindow* window,
  vtkRenderer* renderer, const std::function<bool(double)>& onBand = nullptr);

/// Stops what a window draws, during a search for the steps that keep a tolerance, once a function
/// says so, for the lifetime of this object. The window asks a few times per second. A drawing that
/// was stopped leaves no image.
class StopCheck
{
public:
  /// @param window    which outlives this object
  /// @param isWanted  may make another context current
  StopCheck(vtkRenderWindow* window, std::function<bool()> isWanted);
  ~StopCheck();
  StopCheck(const StopCheck&) = delete;
  StopCheck& operator=(const StopCheck&) = delete;

private:
  void Check();

  vtkRenderWindow* window;
  std::function<bool()> isWanted;
  vtkNew<vtkCallbackCommand> command;
};

}

#endif
