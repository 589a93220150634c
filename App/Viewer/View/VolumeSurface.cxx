#include "Viewer/View/VolumeSurface.h"

namespace varimarch
{

VolumeSurface::VolumeSurface(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->setFocusPolicy(Qt::NoFocus);
}

void VolumeSurface::initializeGL()
{
  QVTKOpenGLNativeWidget::initializeGL();
  emit this->ContextIsNew();
}

}
