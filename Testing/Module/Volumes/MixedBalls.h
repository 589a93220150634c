#ifndef Varimarch_Testing_MixedBalls_h
#define Varimarch_Testing_MixedBalls_h

#include "Module/Scenes/OverlapLight.h"

/// Two balls as two volumes that overlap, and the same balls as two components of one volume.
struct MixedBalls
{
  explicit MixedBalls(int size)
    : volumes(size)
    , components(size)
  {
    const auto valueOf = [](glm::ivec3 voxel, int ball)
    {
      return BallField(
        glm::dvec3(voxel), ball ? glm::dvec3(8.0, 6.0, 8.0) : glm::dvec3(6.0, 7.0, 6.0));
    };
    for (int i = 0; i < 2; ++i)
    {
      this->volumes
        .Add(i, Placed(1, [&](glm::ivec3 voxel, int) { return valueOf(voxel, i); }), ballLooks[i])
        ->GetProperty()
        ->ShadeOn();
    }
    vtkVolumeProperty* const property =
      this->components.Add(0, Placed(2, valueOf), ballLooks[0])->GetProperty();
    property->IndependentComponentsOn();
    property->ShadeOn();
    SetLook(property, 1, ballLooks[1]);
  }

  /// Lights both scenes alike.
  void Use(const OverlapLight& light)
  {
    UseLight(this->volumes, light);
    UseLight(this->components, light);
    vtkVolumeProperty* const property = this->components.Volumes().front()->GetProperty();
    property->SetAmbient(1, property->GetAmbient(0));
    property->SetDiffuse(1, property->GetDiffuse(0));
    property->SetSpecular(1, property->GetSpecular(0));
  }

  OverlapScene volumes;
  OverlapScene components;

private:
  static vtkSmartPointer<vtkImageData> Placed(int count, const Values& valueOf)
  {
    const auto image = ImageOf(VTK_DOUBLE, count, valueOf, { 14, 15, 13 });
    image->SetOrigin(-6.5, -7.0, -6.0);
    return image;
  }
};

#endif
