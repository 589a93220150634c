#include "BoxesOfProcesses.h"

#include "Core/Blocks/BoxOrder.h"

#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <vector>

namespace varimarch
{

namespace
{

vtkBoundingBox BoundsOfVolumes(vtkRenderer* renderer)
{
  vtkBoundingBox bounds;
  vtkCollectionSimpleIterator iterator;
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  for (volumes->InitTraversal(iterator); vtkVolume* volume = volumes->GetNextVolume(iterator);)
  {
    if (volume->GetVisibility() && volume->GetBounds())
    {
      bounds.AddBounds(volume->GetBounds());
    }
  }
  return bounds;
}

}

// ParaView's representation gives the view the box before the volume is turned, and the view then
// composites the parts in a wrong order.
void TurnBounds(const double bounds[6], vtkMatrix4x4* worldFromData, double turned[6])
{
  const vtkBoundingBox box(bounds);
  vtkBoundingBox around;
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double position[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, position);
    worldFromData->MultiplyPoint(position, position);
    around.AddPoint(position);
  }
  constexpr double Gap = 1e-6;
  around.ScaleAboutCenter(1.0 - Gap);
  around.GetBounds(turned);
}

std::optional<std::pair<int, int>> OverlappingProcesses(
  vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  double own[6];
  BoundsOfVolumes(renderer).GetBounds(own);
  const int count = controller->GetNumberOfProcesses();
  std::vector<double> all(6 * std::size_t(count));
  controller->AllGather(own, all.data(), 6);
  std::vector<Box> boxes;
  std::vector<int> owners;
  for (int process = 0; process < count; ++process)
  {
    const double* const box = &all[6 * std::size_t(process)];
    if (box[0] <= box[1])
    {
      boxes.push_back({ { box[0], box[2], box[4] }, { box[1], box[3], box[5] } });
      owners.push_back(process);
    }
  }
  const auto overlap = FirstOverlap(boxes);
  return overlap ? std::optional(std::pair(owners[overlap->first], owners[overlap->second]))
                 : std::nullopt;
}

}
