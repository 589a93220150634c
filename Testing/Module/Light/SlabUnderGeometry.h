#ifndef Varimarch_Testing_SlabUnderGeometry_h
#define Varimarch_Testing_SlabUnderGeometry_h

#include "Module/Light/UndrawnActor.h"
#include "Module/Scenes/SlabScene.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <vector>

inline const glm::dvec3 TowardsSun(0.6, 0.0, 0.8);

/// A rectangle parallel to the slab, above it.
inline vtkSmartPointer<vtkPlaneSource> Sheet(double left, double right, double height)
{
  const auto sheet = vtkSmartPointer<vtkPlaneSource>::New();
  sheet->SetOrigin(left, -100.0, height);
  sheet->SetPoint1(right, -100.0, height);
  sheet->SetPoint2(left, 100.0, height);
  sheet->SetResolution(3, 5);
  return sheet;
}

/// An actor that casts shadows and is not in the image.
inline vtkSmartPointer<vtkActor> HiddenActor(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  return UndrawnActor::Of(mapper);
}

/// A slab with diffuse light, in whose middle the eye looks down along x = 0.
class SlabUnderGeometry
{
public:
  static constexpr double Red = 0.8;
  static constexpr double OpacityPerMm = 0.3;
  static constexpr double ThicknessMm = 8.0;

  SlabUnderGeometry()
    : scene(OpacityPerMm, Red)
  {
    this->scene.LightDiffusely();
    this->scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
    this->scene.mapper->AutoAdjustSampleDistancesOff();
    this->scene.mapper->SetSampleDistance(0.02f);
  }

  vtkLight* AddSun() { return AddLight(this->scene.renderer, 100.0 * TowardsSun, glm::dvec3(0.0)); }

  double DrawnRed()
  {
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    return drawn[4 * (drawn.size() / 8)];
  }

  SlabScene scene;
};

#endif
