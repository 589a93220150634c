#include "Frame/RendererVolumes.h"

#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace varimarch
{

namespace
{

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

std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer)
{
  std::vector<vtkVolume*> volumes;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    auto* mapper =
      volume ? vtkVariationFieldVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
    if (mapper && volume->GetVisibility() && mapper->GetDataObjectInput())
    {
      volumes.push_back(volume);
    }
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  std::stable_sort(volumes.begin(), volumes.end(),
    [&](vtkVolume* one, vtkVolume* other)
    { return DistanceOf(one, camera) > DistanceOf(other, camera); });
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
