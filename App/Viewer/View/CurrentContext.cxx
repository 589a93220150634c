#include "Viewer/View/CurrentContext.h"

#include <QOpenGLContext>

#include <EGL/egl.h>

namespace varimarch
{

DrawingWithoutDisplay::DrawingWithoutDisplay()
{
  if (QOpenGLContext* const current = QOpenGLContext::currentContext())
  {
    current->doneCurrent();
  }
}

DrawingWithoutDisplay::~DrawingWithoutDisplay()
{
  if (eglGetCurrentContext() != EGL_NO_CONTEXT)
  {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

}
