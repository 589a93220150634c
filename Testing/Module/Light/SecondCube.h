#ifndef Varimarch_Testing_SecondCube_h
#define Varimarch_Testing_SecondCube_h

#include "Module/Scenes/CubeAboveFloor.h"

/// Another dark cube, with a mapper of its own.
class SecondCube
{
public:
  SecondCube(CubeAboveFloor& first, glm::dvec3 center)
    : center(center)
    , first(first)
  {
    this->mapper->SetInputData(first.scene.image);
    this->mapper->SetErrorTolerance(0.0);
    this->mapper->ShadowsOn();
    this->volume->SetMapper(this->mapper);
    this->volume->SetProperty(first.scene.volume->GetProperty());
    this->volume->SetPosition(center.x, center.y, center.z);
    first.scene.renderer->AddVolume(this->volume);
  }

  double Leaves(glm::dvec3 place, glm::dvec3 towards) const
  {
    return LeftBehindCube(place - this->center, towards);
  }

  /// Compares red on the floor as CubeAboveFloor does, with either volume as the first to be drawn.
  void ExpectRedInBothOrders(
    const std::function<double(glm::dvec3 place)>& truth, double tolerance) const
  {
    this->first.ExpectRed(truth, tolerance);
    this->first.scene.renderer->RemoveVolume(this->first.scene.volume);
    this->first.scene.renderer->AddVolume(this->first.scene.volume);
    this->first.ExpectRed(truth, tolerance);
  }

  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;
  glm::dvec3 center;

private:
  CubeAboveFloor& first;
};

/// A place above the first cube and beside the view, so that VTK culls it. Their shadows overlap.
inline constexpr glm::dvec3 AboveFirst(8.0, 0.5, 18.0);

#endif
