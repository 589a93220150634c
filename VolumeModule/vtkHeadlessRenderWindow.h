/**
 * @class   vtkHeadlessRenderWindow
 * @brief   A render window without a display, using OpenGL through EGL
 *
 * Debian's VTK only has an X11 window. This window creates its own EGL context on the first device
 * that offers one: a GPU's driver or else Mesa's software rasterizer. Programs and tests can
 * therefore run over ssh, in a container and in CI. It always draws off screen; read images back as
 * from any vtkRenderWindow.
 *
 * If no context is available, or if this thread or process cannot use it, Render() draws nothing
 * and reports the reason once as a VTK error. InitializeContext() tests for a context beforehand.
 *
 * A renderer with depth peeling cannot have multisamples; Render() sets their number to 0 and
 * warns.
 *
 * Several windows may show the same volume. Each has a context of its own, to which graphics
 * resources belong, so that the volume is uploaded again whenever the other window renders.
 */

#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // For the EGL context
#include <string> // For FailureReason

class VARIMARCHVOLUME_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);

  /**
   * Creates the context unless there is one. Returns false and sets FailureReason if EGL offers
   * none.
   */
  bool InitializeContext();
  const std::string& GetFailureReason() const { return this->FailureReason; }

  /**
   * Name of the OpenGL renderer, such as "llvmpipe (LLVM 15.0.6, 256 bits)"; "none" without a
   * context.
   */
  std::string GetDeviceName();

  void Initialize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  void OpenGLInitContext() override;

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  struct Context;
  std::unique_ptr<Context> Graphics;
  std::string FailureReason;
  bool TryToMakeCurrent();

  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;
};

#endif
