#ifndef Varimarch_Scene_OffscreenView_h
#define Varimarch_Scene_OffscreenView_h

#include "Scene/ScenePipeline.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

namespace varimarch
{

/// A scene with a window that needs no display, for pictures and measurements.
class OffscreenView
{
public:
  /// @throws std::runtime_error when there is no OpenGL
  OffscreenView(const Scene& scene, vtkImageData* image, MapperKind kind);

  ScenePipeline& Pipeline() { return this->pipeline; }

  /// Draws, waits until the device has finished, and returns how long that took [s].
  double Render();

  /// What the last Render drew, as bytes on the background.
  vtkSmartPointer<vtkImageData> Bytes();

  /// Draws anew, see CaptureFloatImage.
  vtkSmartPointer<vtkImageData> FloatImage(const std::function<void(double)>& onBand = nullptr);

  /// The OpenGL renderer's own name.
  std::string DeviceName() { return this->window->GetDeviceName(); }

private:
  ScenePipeline pipeline;
  vtkNew<vtkHeadlessRenderWindow> window;
};

}

#endif
