/**
 * @class   vtkVarimarchFloatPass
 * @brief   draws an image without rounding each surface, volume or part of a process to 8 bits
 *
 * ParaView's vtkIceTCompositePass reads the picture of each process from a framebuffer of 8 bits
 * and composites bytes. Between Begin and End, this pass takes the place of the pass that draws for
 * it: it draws into a framebuffer of floats, lets IceT composite these pictures, and draws the
 * result into the framebuffer of the process that shows it. The others leave theirs empty, so that
 * ParaView's own compositing changes nothing.
 *
 * Every process draws, and all have the same bounds: IceT neither calls a pass for a box that is
 * out of sight, nor reads pixels outside of the box. The bounds are those of all processes.
 *
 * Between BeginAlone and End, one process without others draws into such a framebuffer too, and
 * its pixels over the background, so that they are rounded to 8 bits once.
 */

#ifndef vtkVarimarchFloatPass_h
#define vtkVarimarchFloatPass_h

#include "vtkNew.h" // For members
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h" // For members
#include "vtkWeakPointer.h"  // For members

#include <string> // For ImageFile
#include <vector> // For the order of processes

class vtkCameraPass;
class vtkIceTCompositePass;
class vtkIceTContext;
class vtkMultiProcessController;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;

class vtkVarimarchFloatPass : public vtkRenderPass
{
public:
  static vtkVarimarchFloatPass* New();
  vtkTypeMacro(vtkVarimarchFloatPass, vtkRenderPass);

  /**
   * Composites the image that a renderer begins. All processes must call this.
   * @param order  all processes, front to back
   */
  void Begin(vtkRenderer* renderer, vtkIceTCompositePass* compositePass,
    vtkMultiProcessController* controller, std::vector<int> order);

  /**
   * Draws the image for a camera's pass, without other processes.
   */
  void BeginAlone(vtkCameraPass* cameraPass);

  /**
   * File for the pixels of each image, which the process that shows it writes: red, green, blue and
   * alpha as floats of 32 bits, row by row from the lowest one, premultiplied and without the
   * background. Default "", for none.
   */
  void SetImageFile(const std::string& file) { this->ImageFile = file; }

  /**
   * Gives ParaView its pass back, if Begin or BeginAlone has replaced it.
   */
  void End();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkVarimarchFloatPass();
  ~vtkVarimarchFloatPass() override;

private:
  void Bind(vtkOpenGLRenderWindow* window, const int size[2]);
  std::vector<float> Composite(const std::vector<float>& own, const int size[2]);
  void ShowOverBackground(vtkOpenGLRenderWindow* window, const int size[2]);
  void WriteImage(const std::vector<float>& pixels);

  vtkNew<vtkIceTContext> Context;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<int> Order; // all processes, front to back
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkIceTCompositePass> CompositePass;
  vtkWeakPointer<vtkCameraPass> CameraPass;
  vtkSmartPointer<vtkRenderPass> OwnPass; // the pass that draws for one of these two
  vtkSmartPointer<vtkProp> CommonBounds;
  std::string ImageFile;

  vtkVarimarchFloatPass(const vtkVarimarchFloatPass&) = delete;
  void operator=(const vtkVarimarchFloatPass&) = delete;
};

#endif
