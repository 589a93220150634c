#ifndef Varimarch_Viewer_VtkPictures_h
#define Varimarch_Viewer_VtkPictures_h

#include "Scene/Images/FloatCapture.h"

#include <QImage>
#include <QString>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>

class QPainter;
class QRect;

namespace varimarch
{

/// Conversions between VTK images, whose first row is the lowest, and QImage.

/// @param picture  bytes of RGB
QImage ImageOfBytes(vtkImageData* picture);

/// @param picture  floats of premultiplied RGBA
QImage ImageOfFloats(vtkImageData* picture);

/// Bytes of RGB, or of RGBA for an image with an alpha channel, not premultiplied.
vtkSmartPointer<vtkImageData> BytesOfImage(const QImage& image);

/// An image of VTK's GPU mapper at full quality, rendered in bands between which the window reacts.
/// VTK itself draws an image in one piece, which can take seconds.
class StillPicture
{
public:
  /// Forgets the image, or what is complete of it.
  void Clear();

  /// Begins an image of a renderer after an ordinary frame.
  void Begin(vtkOpenGLRenderWindow* window, vtkRenderer* renderer);

  /// Renders the next band, whose height follows from the time of the last one. True if it
  /// completed the image.
  bool Continue();

  bool IsIncomplete() const { return this->capture.has_value(); }

  /// Premultiplied RGBA, see FloatCapture; null until it is complete.
  vtkImageData* Picture() const { return this->picture; }

  /// Rendering time so far, without the pauses [s].
  double Seconds() const { return this->seconds; }

  /// Paints a complete image.
  void Paint(QPainter& painter, const QRect& rect, const QColor& background) const;

private:
  std::optional<FloatCapture> capture;
  int bandRows = 0;
  double seconds = 0.0;
  vtkSmartPointer<vtkImageData> picture;
  QImage image;
};

/// Lets the thread render without a display during its lifetime. A thread has only one current
/// context: the constructor releases Qt's, and the destructor releases EGL's, because Qt's windows
/// could not draw otherwise.
class DrawingWithoutDisplay
{
public:
  DrawingWithoutDisplay();
  ~DrawingWithoutDisplay();
  DrawingWithoutDisplay(const DrawingWithoutDisplay&) = delete;
  DrawingWithoutDisplay& operator=(const DrawingWithoutDisplay&) = delete;
};

/// Says why windows cannot be drawn in: there is no OpenGL, or one before version 3.2, with which
/// VTK would crash. Empty if they can. Needs a QApplication.
QString OpenGLProblem();

/// True if the processor draws with OpenGL, by Mesa's llvmpipe. Needs a QApplication.
bool IsOpenGLOnProcessor();

}

#endif
