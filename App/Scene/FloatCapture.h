#ifndef Varimarch_Scene_FloatCapture_h
#define Varimarch_Scene_FloatCapture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace varimarch
{

/// Renders once into a framebuffer of 32-bit floats that starts out transparent. The result is
/// premultiplied RGBA without the background and without rounding to 8 bits, the bottom row first.
/// Errors are measured on such images. VTK's GPU mapper must have rendered an ordinary frame
/// before; otherwise its image stays empty.
/// @param window  the renderer's window, of the size to render
/// @param onBand  if given, the image is rendered in horizontal bands, and this is called before
///                each one with the fraction done, [0, 1); for images that take long
/// @throws std::runtime_error if the driver does not support such a framebuffer
vtkSmartPointer<vtkImageData> CaptureFloatImage(vtkOpenGLRenderWindow* window,
  vtkRenderer* renderer, const std::function<void(double)>& onBand = nullptr);

}

#endif
