#ifndef Varimarch_Viewer_VolumeSurface_h
#define Varimarch_Viewer_VolumeSurface_h

#include <QVTKOpenGLNativeWidget.h>

namespace varimarch
{

/// The part of a view that OpenGL draws. Its view, which is its parent, takes the mouse and the
/// keys. While it is visible, Qt composes the whole window by OpenGL, which takes long where the
/// processor does that; so it is hidden where a thread draws the images.
class VolumeSurface : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit VolumeSurface(QWidget* parent);

signals:
  /// There is an OpenGL context, the first one or another one after a reset of the graphics card.
  void ContextIsNew();

protected:
  void initializeGL() override;
};

}

#endif
