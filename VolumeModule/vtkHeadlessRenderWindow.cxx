#include "vtkHeadlessRenderWindow.h"

#include "VtkVersions.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

// Xlib's macros (Status, None, ...) would collide with names of VTK.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ios>
#include <sstream>
#include <stack>
#include <vector>

namespace
{

// All displays worth trying: first the drivers' devices, so that a GPU is preferred to software.
std::vector<EGLDisplay> CandidateDisplays()
{
  std::vector<EGLDisplay> displays;
  const auto queryDevices =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!platformDisplay)
  {
    return displays;
  }
  if (queryDevices)
  {
    std::array<EGLDeviceEXT, 16> devices = {};
    EGLint deviceCount = 0;
    if (queryDevices(EGLint(devices.size()), devices.data(), &deviceCount))
    {
      for (EGLint i = 0; i < deviceCount; ++i)
      {
        displays.push_back(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
    }
  }
  displays.push_back(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return displays;
}

// A display, surface and context that were current, to be made so again.
struct CurrentContext
{
  EGLDisplay Display = eglGetCurrentDisplay();
  EGLSurface Surface = eglGetCurrentSurface(EGL_DRAW);
  EGLContext Handle = eglGetCurrentContext();

  void Restore() const
  {
    if (this->Display != EGL_NO_DISPLAY)
    {
      eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Handle);
    }
  }
};

// True in a copy of a process that already had a context. The threads of its driver do not exist in
// the copy, which would wait for them forever.
bool IsForkedAfterUse()
{
  static const pid_t firstUser = getpid();
  return getpid() != firstUser;
}

// A context that tells if the graphics card is reset, where the driver has such contexts.
EGLContext CoreContext(EGLDisplay display, EGLConfig config)
{
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
    EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE };
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (context != EGL_NO_CONTEXT)
  {
    return context;
  }
  std::array<EGLint, 7> fewer = {};
  std::copy_n(attributes, 6, fewer.begin());
  fewer[6] = EGL_NONE;
  return eglCreateContext(display, config, EGL_NO_CONTEXT, fewer.data());
}

bool PeelsAny(vtkRendererCollection* renderers)
{
  vtkCollectionSimpleIterator iterator;
  renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(iterator))
  {
    if (renderer->GetUseDepthPeeling())
    {
      return true;
    }
  }
  return false;
}

constexpr const char* ForkedReason =
  "OpenGL was in use before this process was forked from another, and cannot be used in both: "
  "start "
  "the process anew, in Python by multiprocessing.set_start_method(\"spawn\")";

std::string ReasonNotCurrent()
{
  if (IsForkedAfterUse())
  {
    return ForkedReason;
  }
  const EGLint error = eglGetError();
  if (error == EGL_BAD_ACCESS)
  {
    return "The window is in use in another thread: render it in one thread only";
  }
  std::ostringstream reason;
  reason << "The window's OpenGL context cannot be made current (EGL error 0x" << std::hex << error
         << "): make a new window";
  return reason.str();
}

}

struct vtkHeadlessRenderWindow::Context
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Surface = EGL_NO_SURFACE;
  EGLContext Handle = EGL_NO_CONTEXT;
  std::stack<CurrentContext> Pushed; // The contexts that pushing this one replaced.

  // Returns true if the display offers a core OpenGL context and a surface to make it current with.
  bool CreateOn(EGLDisplay display)
  {
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor) ||
      !eglBindAPI(EGL_OPENGL_API))
    {
      return false;
    }
    // VTK draws into buffers of its own, but asks the surface for the bits of its depth, which is
    // an error of OpenGL if it has none.
    const EGLint configAttributes[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24,
      EGL_NONE };
    EGLConfig config = nullptr;
    EGLint configCount = 0;
    if (!eglChooseConfig(display, configAttributes, &config, 1, &configCount) || configCount == 0)
    {
      return false;
    }
    // VTK draws into its own framebuffer objects; the surface is needed only to make the context
    // current.
    const EGLint surfaceAttributes[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    this->Display = display;
    this->Handle = CoreContext(display, config);
    this->Surface = eglCreatePbufferSurface(display, config, surfaceAttributes);
    if (this->Handle == EGL_NO_CONTEXT || this->Surface == EGL_NO_SURFACE || !this->MakeCurrent())
    {
      this->Destroy();
      return false;
    }
    return true;
  }

  bool MakeCurrent() const
  {
    return !IsForkedAfterUse() &&
      eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Handle) == EGL_TRUE;
  }

  void Destroy()
  {
    if (this->Display == EGL_NO_DISPLAY)
    {
      return;
    }
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (this->Surface != EGL_NO_SURFACE)
    {
      eglDestroySurface(this->Display, this->Surface);
    }
    if (this->Handle != EGL_NO_CONTEXT)
    {
      eglDestroyContext(this->Display, this->Handle);
    }
    *this = Context();
  }
};

vtkStandardNewMacro(vtkHeadlessRenderWindow);

vtkHeadlessRenderWindow::vtkHeadlessRenderWindow()
{
  this->SetFrameBlitModeToNoBlit();
  this->SetReadyForRendering(false);
  this->MultiSamples = 0;
}

vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  if (this->Graphics)
  {
    // Finalized here, where MakeCurrent still works; the base class would release without a
    // context.
    this->Finalize();
    this->Graphics->Destroy();
  }
}

bool vtkHeadlessRenderWindow::InitializeContext()
{
  if (this->Graphics)
  {
    return true;
  }
  if (!this->FailureReason.empty())
  {
    return false;
  }
  if (IsForkedAfterUse())
  {
    this->FailureReason = ForkedReason;
    return false;
  }
  auto context = std::make_unique<Context>();
  for (EGLDisplay display : CandidateDisplays())
  {
    if (context->CreateOn(display))
    {
      this->Graphics = std::move(context);
      this->SetReadyForRendering(true);
      this->InitializeFromCurrentContext();
      this->OwnContext = 1;
      return true;
    }
  }
  this->FailureReason = "No EGL device gives an OpenGL 3.2 core context; "
                        "on Debian the packages libegl1 and libgl1-mesa-dri provide one.";
  return false;
}

void vtkHeadlessRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  const std::string fault = varimarch::LoadOpenGL(eglGetProcAddress);
  VARIMARCH_SET_OPENGL_LOADED(fault.empty());
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot load the OpenGL functions: " << fault);
    return;
  }
  this->Initialized = true;
  this->MaximumHardwareLineWidth = 1.0f;
}

std::string vtkHeadlessRenderWindow::GetDeviceName()
{
  if (!this->InitializeContext())
  {
    return "none";
  }
  this->MakeCurrent();
  const GLubyte* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "unknown";
}

void vtkHeadlessRenderWindow::Initialize()
{
  if (!this->Graphics && this->FailureReason.empty() && !this->InitializeContext())
  {
    vtkErrorMacro(<< this->FailureReason);
  }
}

void vtkHeadlessRenderWindow::Render()
{
  this->Initialize();
  if (this->MultiSamples > 0 && PeelsAny(this->GetRenderers()))
  {
    this->SetMultiSamples(0);
    vtkWarningMacro("Depth peeling and multisampling exclude each other: the number of samples is "
                    "set to 0.");
  }
  if (!this->Graphics || this->TryToMakeCurrent())
  {
    this->Superclass::Render();
  }
}

void vtkHeadlessRenderWindow::MakeCurrent()
{
  if (this->Graphics)
  {
    this->TryToMakeCurrent();
  }
}

// Reports the reason once if the context cannot be made current.
bool vtkHeadlessRenderWindow::TryToMakeCurrent()
{
  if (this->Graphics->MakeCurrent())
  {
    this->FailureReason.clear();
    return true;
  }
  const std::string reason = ReasonNotCurrent();
  if (reason != this->FailureReason)
  {
    this->FailureReason = reason;
    vtkErrorMacro(<< reason << ".");
  }
  return false;
}

bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Graphics && eglGetCurrentContext() == this->Graphics->Handle;
}

void vtkHeadlessRenderWindow::PushContext()
{
  if (this->Graphics)
  {
    this->Graphics->Pushed.push(CurrentContext());
    this->MakeCurrent();
  }
}

void vtkHeadlessRenderWindow::PopContext()
{
  if (this->Graphics && !this->Graphics->Pushed.empty())
  {
    this->Graphics->Pushed.top().Restore();
    this->Graphics->Pushed.pop();
  }
}
