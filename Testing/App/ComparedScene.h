#ifndef Varimarch_Testing_ComparedScene_h
#define Varimarch_Testing_ComparedScene_h

#include "Benchmarks/Comparison/vtkComparisonMapper.h"

#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vector>

/// Scenes that the comparison methods of the benchmarks draw.

using Pixels = std::vector<float>;

// A look without steep slopes, so that rounding of positions hardly shows.
inline varimarch::Scene SoftScene(bool shaded)
{
  varimarch::Scene scene;
  scene.look.colors = { { -1000.0, { 0.1, 0.3, 1.0 } }, { 1500.0, { 1.0, 0.7, 0.2 } } };
  scene.look.opacities = { { -600.0, 0.0 }, { 1500.0, 0.25 } };
  scene.look.opacityUnitDistanceMm = 10.0;
  scene.look.shading.enabled = shaded;
  scene.camera.azimuthDegrees = 25.0;
  scene.camera.elevationDegrees = 15.0;
  scene.size = { 64, 56 };
  return scene;
}

inline vtkSmartPointer<vtkImageData> Torso(const std::array<int, 3>& size = { 40, 36, 24 })
{
  return varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, size, 7 });
}

inline Pixels PixelsOf(vtkImageData* picture)
{
  const auto* const channels = static_cast<const float*>(picture->GetScalarPointer());
  return Pixels(channels, channels + 4 * picture->GetNumberOfPoints());
}

// A scene that one of the comparison methods draws.
struct ComparedScene
{
  vtkSmartPointer<vtkImageData> image;
  varimarch::OffscreenView view;
  vtkNew<vtkComparisonMapper> mapper;

  explicit ComparedScene(
    const varimarch::Scene& scene, vtkSmartPointer<vtkImageData> volume = Torso())
    : image(volume)
    , view(scene, volume, varimarch::MapperKind::VarimarchShaders)
  {
    this->mapper->SetInputDataObject(this->image);
    this->mapper->SetSampleDistance(4.0);
    this->view.Pipeline().Volume()->SetMapper(this->mapper);
  }

  Pixels Draw(int method)
  {
    this->mapper->SetMethod(method);
    return PixelsOf(this->view.FloatImage());
  }
};

inline varimarch::ImageError Difference(const Pixels& one, const Pixels& other)
{
  return varimarch::CompareImages(one.data(), other.data(), other.size() / 4);
}

#endif
