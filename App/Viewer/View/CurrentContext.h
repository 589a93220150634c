#ifndef Varimarch_Viewer_CurrentContext_h
#define Varimarch_Viewer_CurrentContext_h

#include <QOpenGLContext>

namespace varimarch
{

/// Lets go of the context of Qt that is current. A thread has one, be it of a window or without a
/// display: to be called before anything is drawn without one.
inline void LeaveCurrentContext()
{
  if (QOpenGLContext* const current = QOpenGLContext::currentContext())
  {
    current->doneCurrent();
  }
}

}

#endif
