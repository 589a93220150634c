#ifndef Varimarch_Viewer_StillPicture_h
#define Varimarch_Viewer_StillPicture_h

#include "Scene/FloatCapture.h"

#include <QImage>

#include <optional>

class QPainter;
class QRect;

namespace varimarch
{

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

}

#endif
