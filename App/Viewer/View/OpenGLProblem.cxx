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
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface))
  {
    return Problem(QCoreApplication::translate("OpenGLProblem", "none"));
  }
  const auto [major, minor] = context.format().version();
  if (qMakePair(major, minor) < qMakePair(3, 2))
  {
    return Problem(QStringLiteral("%1.%2").arg(major).arg(minor));
  }
  const bool works = VtkCanUseContext();
  context.doneCurrent();
  return works ? QString()
               : Problem(QCoreApplication::translate("OpenGLProblem", "a display without GLX"));
}

bool IsOpenGLOnProcessor()
{
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface))
  {
    return false;
  }
  const auto* const device =
    reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const bool isProcessor = QString::fromLatin1(device).contains("llvmpipe");
  context.doneCurrent();
  return isProcessor;
}

}
