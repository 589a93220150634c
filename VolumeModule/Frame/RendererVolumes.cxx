#include "Frame/RendererVolumes.h"

#include "Frame/DrawnPart.h"
#include "vtkVariationFieldGPUVolumeRayCastMapper.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace varimarch
{

namespace
{

// A volume and the order of drawing that its place suggests: smaller is drawn earlier.
struct Placed
{
  vtkVolume* volume;
  DrawnPart part;
  float nearness;  ///< minus the distance from the camera; centres may differ by rounding
  double openness; ///< minus the size: what surrounds another comes first

  bool operator<(const Placed& other) const
  {
    return std::tie(this->nearness, this->openness) < std::tie(other.nearness, other.openness);
  }
};

// The distance of a place from the camera; in a parallel projection, along the view.
double DistanceOf(const glm::dvec3& place, vtkCamera* camera)
{
  const glm::dvec3 fromCamera = place - glm::make_vec3(camera->GetPosition());
  return camera->GetParallelProjection()
    ? glm::dot(fromCamera, glm::make_vec3(camera->GetDirectionOfProjection()))
    : glm::length(fromCamera);
}

Placed PlacedIn(vtkVolume* volume, vtkCamera* camera)
{
  DrawnPart part = DrawnPartOf(volume);
  const double distance = DistanceOf(part.Center(), camera);
  const double length = part.Length();
  return { volume, std::move(part), -float(distance), -length };
}

// True if no other volume is known to be behind one.
bool IsFarthest(const Placed& one, const std::vector<Placed>& all, vtkCamera* camera)
{
  return std::none_of(all.begin(), all.end(),
    [&](const Placed& other)
    { return SidesOf(one.part, other.part, camera) == Sides::FirstInFront; });
}

}

vtkVariationFieldVolumeMapper* DrawingMapper(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* const mapper = volume->GetMapper();
  auto* const adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return adapter ? adapter->GetVariationFieldMapper()
                 : vtkVariationFieldVolumeMapper::SafeDownCast(mapper);
}

bool IsLeftToVtk(vtkVolume* volume, vtkRenderer* renderer)
{
  auto* const adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  return adapter && !adapter->ChooseMapper(renderer, volume);
}

std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  std::vector<Placed> left;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && DrawingMapper(volume) && volume->GetVisibility() &&
      volume->GetMapper()->GetDataObjectInput())
    {
      left.push_back(PlacedIn(volume, camera));
    }
  }
  std::stable_sort(left.begin(), left.end());

  // The first that covers no other is drawn next; where all cover each other in a ring, the first.
  std::vector<vtkVolume*> volumes;
  while (!left.empty())
  {
    const auto farthest = std::find_if(
      left.begin(), left.end(), [&](const Placed& one) { return IsFarthest(one, left, camera); });
    const auto next = farthest == left.end() ? left.begin() : farthest;
    volumes.push_back(next->volume);
    left.erase(next);
  }
  return volumes;
}

vtkMTimeType TimeOf(const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer)
{
  vtkMTimeType time = std::max(renderer->GetMTime(), renderer->GetActiveCamera()->GetMTime());
  for (vtkVolume* volume : volumes)
  {
    time = std::max(time, volume->GetMTime());
  }
  return time;
}

}
