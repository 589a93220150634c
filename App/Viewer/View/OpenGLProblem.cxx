#include "Viewer/View/OpenGLProblem.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

namespace varimarch
{

namespace
{

QString Problem(const QString& found)
{
  return QCoreApplication::translate("OpenGLProblem",
    "OpenGL 3.2 or later is needed, found %1; install or update the driver of the graphics card, "
    "or the package libgl1-mesa-dri, which draws without one")
    .arg(found);
}

/// A context without a window, which is current as long as it lives.
class HiddenContext
{
public:
  HiddenContext()
  {
    this->surface.create();
    this->isCurrent = this->context.create() && this->context.makeCurrent(&this->surface);
  }

  /// Null if there is no OpenGL.
  QOpenGLContext* Get() { return this->isCurrent ? &this->context : nullptr; }

private:
  QOffscreenSurface surface;
  QOpenGLContext context;
  bool isCurrent;
};

// True if VTK finds its functions in the current context. Debian's VTK looks for them by GLX only,
// whereas Qt may have made the context by EGL.
bool VtkCanUseContext()
{
  bool works = true;
  vtkNew<vtkCallbackCommand> failed;
  failed->SetClientData(&works);
  failed->SetCallback(
    [](vtkObject*, unsigned long, void* works, void*) { *static_cast<bool*>(works) = false; });
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->AddObserver(vtkCommand::ErrorEvent, failed);
  window->OpenGLInitContext();
  return works;
}

}

QString OpenGLProblem()
{
  HiddenContext hidden;
  if (!hidden.Get())
  {
    return Problem(QCoreApplication::translate("OpenGLProblem", "none"));
  }
  const auto [major, minor] = hidden.Get()->format().version();
  if (qMakePair(major, minor) < qMakePair(3, 2))
  {
    return Problem(QStringLiteral("%1.%2").arg(major).arg(minor));
  }
  return VtkCanUseContext()
    ? QString()
    : Problem(QCoreApplication::translate("OpenGLProblem", "a display without GLX"));
}

bool IsOpenGLOnProcessor()
{
  HiddenContext hidden;
  if (!hidden.Get())
  {
    return false;
  }
  const auto* const device =
    reinterpret_cast<const char*>(hidden.Get()->functions()->glGetString(GL_RENDERER));
  return QString::fromLatin1(device).contains("llvmpipe");
}

}
