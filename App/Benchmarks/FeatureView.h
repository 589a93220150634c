#ifndef Varimarch_Benchmarks_FeatureView_h
#define Varimarch_Benchmarks_FeatureView_h

#include "FeatureList.h"
#include "Scene/Model/Scene.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace varimarch
{

/// A window that shows a scene through the interface that all of VTK's GPU mappers share.
class FeatureView
{
public:
  FeatureView(
    const Scene& scene, vtkImageData* image, vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper);

  FeatureStage Stage() { return { this->mapper, this->volume, this->renderer, this->image }; }

  void Render() { this->window->Render(); }

  /// The time of a frame after the switched feature has been built [ms].
  /// @throws std::runtime_error when the mapper reports an error
  double MedianMs();

  /// True if the last frame is black everywhere.
  bool ShowsNothing();

private:
  void Sweep(std::vector<double>& timesMs);

  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
};

}

#endif
