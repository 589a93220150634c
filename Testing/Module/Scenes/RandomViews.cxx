#include "Module/Scenes/RandomScenes.h"

#include <vtkPlane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace
{

using Vector = std::array<double, 3>;

Vector RandomDirection(Dice& dice)
{
  Vector direction{ dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0) };
  if (dice.Chance(0.15))
  {
    direction = { 0.0, 0.0, 0.0 };
    direction[std::size_t(dice.Whole(0, 2))] = dice.OneOf<double>({ -1.0, 1.0 });
  }
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  return length > 0.0
    ? Vector{ direction[0] / length, direction[1] / length, direction[2] / length }
    : Vector{ 0.0, 0.0, 1.0 };
}

// The axis that is least parallel to a direction.
Vector UpOf(const Vector& direction)
{
  const auto isLess = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto least = std::min_element(direction.begin(), direction.end(), isLess);
  Vector up{ 0.0, 0.0, 0.0 };
  up[std::size_t(least - direction.begin())] = 1.0;
  return up;
}

// A place in the volume's bounds, not at their ends.
Vector RandomPlace(const double bounds[6], Dice& dice)
{
  Vector place;
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] =
      bounds[2 * axis] + dice.Between(0.15, 0.85) * (bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  return place;
}

void PlaceVolume(vtkVolume* volume, Dice& dice, std::ostream& text)
{
  if (dice.Chance(0.7))
  {
    return;
  }
  volume->RotateWXYZ(
    dice.Between(0.0, 360.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), 1.0);
  const double mirror = dice.Chance(0.3) ? -1.0 : 1.0;
  volume->SetScale(mirror * dice.Between(0.6, 1.6), dice.Between(0.6, 1.6), 1.0);
  text << ", placed" << (mirror < 0.0 ? " mirrored" : "");
}

// Looks from within the volume, with the clipping range of a program that does not adapt it.
void LookFromInside(MapperScene& scene, const Vector& direction, Dice& dice)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  const Vector eye = RandomPlace(scene.volume->GetBounds(), dice);
  const double length = scene.volume->GetLength();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(
    eye[0] + direction[0] * length, eye[1] + direction[1] * length, eye[2] + direction[2] * length);
  camera->SetViewAngle(dice.Between(40.0, 100.0));
  camera->SetClippingRange(1e-3 * length, 10.0 * length);
}

}

std::string SetRandomView(MapperScene& scene, Dice& dice)
{
  std::ostringstream text;
  PlaceVolume(scene.volume, dice, text);
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  const Vector direction = RandomDirection(dice);
  const std::string kind =
    dice.OneOf<std::string>({ "outside", "outside", "parallel", "inside", "far" });
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(direction.data());
  camera->SetViewUp(UpOf(direction).data());
  camera->SetViewAngle(kind == "far" ? 0.05 : dice.Between(15.0, 60.0));
  kind == "parallel" ? camera->ParallelProjectionOn() : camera->ParallelProjectionOff();
  scene.renderer->ResetCamera(scene.volume->GetBounds());
  camera->Zoom(dice.Between(0.9, 2.5));
  if (kind == "inside")
  {
    LookFromInside(scene, direction, dice);
  }
  else if (dice.Chance(0.1))
  {
    // The near plane cuts the volume.
    camera->SetClippingRange(camera->GetDistance(), 2.0 * camera->GetDistance());
    text << ", cut by the near plane";
  }
  text << ", seen from " << kind << " along " << -direction[0] << " " << -direction[1] << " "
       << -direction[2];
  return text.str();
}

std::string SetRandomCuts(MapperScene& scene, Dice& dice)
{
  std::ostringstream text;
  if (dice.Chance(0.15))
  {
    const int count = dice.Whole(1, 3);
    for (int i = 0; i < count; ++i)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(RandomDirection(dice).data());
      plane->SetOrigin(RandomPlace(scene.volume->GetBounds(), dice).data());
      scene.mapper->AddClippingPlane(plane);
    }
    text << ", " << count << " clipping planes";
  }
  if (dice.Chance(0.15))
  {
    double bounds[6];
    scene.image->GetBounds(bounds);
    double planes[6];
    for (int axis = 0; axis < 3; ++axis)
    {
      // A volume one voxel thick lies beyond its bounds, which have no width.
      const double width = std::max(bounds[2 * axis + 1] - bounds[2 * axis], 0.5);
      planes[2 * axis] = bounds[2 * axis] + dice.Between(-0.2, 0.4) * width;
      planes[2 * axis + 1] = planes[2 * axis] + dice.Between(0.1, 0.6) * width;
    }
    const int flags = dice.OneOf<int>({ VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_CROSS,
      VTK_CROP_INVERTED_CROSS, dice.Whole(1, 0x7ffffff) });
    scene.mapper->CroppingOn();
    scene.mapper->SetCroppingRegionPlanes(planes);
    scene.mapper->SetCroppingRegionFlags(flags);
    text << ", cropped " << flags;
  }
  return text.str();
}
