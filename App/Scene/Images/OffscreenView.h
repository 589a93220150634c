#ifndef Varimarch_Scene_OffscreenView_h
#define Varimarch_Scene_OffscreenView_h

#include "Scene/Pipeline/ScenePipeline.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <string>

namespace varimarch
{

/// A scene in a window that needs no display, for images and measurements.
class OffscreenView
{
public:
  /// @throws std::runtime_error if there is no OpenGL
  OffscreenView(const Scene& scene, vtkImageData* image, MapperKind kind);

  ScenePipeline& Pipeline() { return this->pipeline; }
  const ScenePipeline& Pipeline() const { return this->pipeline; }

  /// Sets the size of the images [pixels].
  void Resize(int width, int height) { this->window->SetSize(width, height); }

  /// Sets the rate that images keep while somebody interacts; below 1 per second they are fine.
  void SetPicturesPerSecond(double rate) { this->window->SetDesiredUpdateRate(rate); }

  /// Renders, waits for the device to finish, and returns the time that this took [s].
  double Render();

  /// The same, but StopCheck stops it once the image is not wanted any more.
  /// @return the time; empty if it was stopped
  std::optional<double> RenderWhile(const std::function<bool()>& isWanted);

  /// Renders until a further image of the scene would not be more exact, see
  /// vtkVariationFieldVolumeMapper::RefinedLevel, and returns the time that this took [s].
  /// @param onImage  called for each image with the time since the beginning [s]
  double RenderAll(const std::function<void(double)>& onImage = nullptr);

  /// The last rendered frame over its background, as a byte image.
  vtkSmartPointer<vtkImageData> Bytes();

  /// The reason why the last frame shows nothing but its background, and what helps, in one
  /// sentence; empty if it shows something, see EmptyPicture.h.
  std::string ReasonForNothing(const Scene& scene);

  /// Renders again into a float image; see CaptureFloatImage. A refined level is rendered as
  /// by RenderAll before.
  vtkSmartPointer<vtkImageData> FloatImage(const std::function<bool(double)>& onBand = nullptr);

  /// The name that the OpenGL driver gives the device.
  std::string DeviceName() { return this->window->GetDeviceName(); }

private:
  ScenePipeline pipeline;
  vtkNew<vtkHeadlessRenderWindow> window;
};

}

#endif
