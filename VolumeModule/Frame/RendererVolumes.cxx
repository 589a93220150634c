#include "Frame/RendererVolumes.h"

#include "vtkVariationFieldGPUVolumeRayCastMapper.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <tuple>

namespace varimarch
{

namespace
{

// The place of a volume in the order of drawing: smaller is drawn earlier.
struct Place
{
  double nearness; ///< minus the distance from the camera
  double inside;   ///< minus the length of the box's diagonal: what surrounds another comes first
  const vtkVolume* volume;

  bool operator<(const Place& other) const
  {
    return std::tie(this->nearness, this->inside, this->volume) <
      std::tie(other.nearness, other.inside, other.volume);
  }
};

// The distance of a volume's centre from the camera; in a parallel projection, along the view.
double DistanceOf(vtkVolume* volume, vtkCamera* camera)
{
  double position[3];
  camera->GetPosition(position);
  double fromCamera[3];
  vtkMath::Subtract(volume->GetCenter(), position, fromCamera);
  return camera->GetParallelProjection()
    ? vtkMath::Dot(fromCamera, camera->GetDirectionOfProjection())
    : vtkMath::Norm(fromCamera);
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
  std::vector<vtkVolume*> volumes;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && DrawingMapper(volume) && volume->GetVisibility() &&
      volume->GetMapper()->GetDataObjectInput())
    {
      volumes.push_back(volume);
    }
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  // The centres of nested boxes may differ by rounding.
  const auto placeOf = [&](vtkVolume* volume) {
    return Place{ -float(DistanceOf(volume, camera)), -volume->GetLength(), volume };
  };
  std::sort(volumes.begin(), volumes.end(),
    [&](vtkVolume* one, vtkVolume* other) { return placeOf(one) < placeOf(other); });
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
