#include "TimesBench.h"

#include "Machine.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr int StillFrames = 10;

// The volume with all rows moved, as if the patient had breathed.
vtkSmartPointer<vtkImageData> MovedByRows(vtkImageData* image, int rows)
{
  auto moved = vtkSmartPointer<vtkImageData>::New();
  moved->DeepCopy(image);
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  const vtkIdType shift = std::min(count, vtkIdType(rows) * image->GetDimensions()[0]);
  moved->GetPointData()->GetScalars()->InsertTuples(0, count - shift, shift, values);
  return moved;
}

}

TimesCost CostOfTimes(const Scene& scene, const LoadedVolume& volume, int times, int frames,
  const std::function<void(int)>& onFrame)
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  for (int time = 0; time < times; ++time)
  {
    images.push_back(MovedByRows(volume.image, time));
  }
  OffscreenView view(scene, images.front(), MapperKind::Varimarch);
  ScenePipeline& pipeline = view.Pipeline();
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(pipeline.Mapper());
  view.Render();
  std::vector<double> still;
  for (int frame = 0; frame < StillFrames; ++frame)
  {
    pipeline.Renderer()->GetActiveCamera()->Azimuth(1.0);
    still.push_back(1000.0 * view.Render());
  }
  TimesCost cost;
  std::vector<double> ofNew;
  std::vector<double> again;
  std::vector<double> ofFields;
  for (int frame = 1; frame <= frames; ++frame)
  {
    pipeline.SetImage(images[std::size_t(frame % times)]);
    (frame < times ? ofNew : again).push_back(1000.0 * view.Render());
    ofFields.push_back(1000.0 * mapper->GetFieldBuildSeconds());
    if (frame == std::min(times, frames))
    {
      cost.residentMegabytesAtFirst = ResidentMegabytes();
    }
    onFrame(frame);
  }
  cost.frames = frames;
  cost.stillMs = Median(still);
  cost.newMs = Median(ofNew);
  cost.againMs = again.empty() ? 0.0 : Median(again);
  cost.fieldMs = Median(ofFields);
  cost.residentMegabytesAtEnd = ResidentMegabytes();
  return cost;
}

}
