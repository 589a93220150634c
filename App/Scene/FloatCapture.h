#ifndef Varimarch_Scene_FloatCapture_h
#define Varimarch_Scene_FloatCapture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace varimarch
{

/// Draws a renderer once into a framebuffer of 32 bit floats, on nothing: RGBA, premultiplied,
/// without the background and without rounding to 8 bits. Row 0 is the picture's lowest. Errors
/// are measured in such pictures. VTK's GPU mapper needs an ordinary picture before, or this one
/// stays empty.
/// @param window  the window of the renderer, of the size to draw
/// @param onBand  when given, the picture is drawn in horizontal bands, and this is called before
///                each with the part that is done, [0, 1): for pictures that take long
/// @throws std::runtime_error when the driver does not allow such a framebuffer
vtkSmartPointer<vtkImageData> CaptureFloatImage(vtkOpenGLRenderWindow* window,
  vtkRenderer* renderer, const std::function<void(double)>& onBand = nullptr);

}

#endif
