/**
 * @class   vtkHeadlessRenderWindow
 * @brief   A render window without a display: OpenGL through EGL's surfaceless platform
 *
 * Debian's VTK has only an X window. This one makes its own EGL context on the first device that
 * gives one (a GPU's driver, else Mesa's software rasteriser), so that programs and tests run over
 * ssh, in a container and in CI. It always draws off screen; read pictures back as usual.
 *
 * When no context can be had, Render does nothing but report the reason once as a VTK error;
 * Initialize() tells in advance.
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
   * Makes the context if there is none yet. False, with FailureReason set, when EGL gives none.
   */
  bool InitializeContext();
  const std::string& GetFailureReason() const { return this->FailureReason; }

  /**
   * The OpenGL renderer's own name, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
   */
  std::string GetDeviceName();

  void Initialize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  void OpenGLInitContext() override;

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  struct Context;
  std::unique_ptr<Context> Graphics;
  std::string FailureReason;

  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;
};

#endif
