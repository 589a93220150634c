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
constexpr double RateInViewer = 15.0; // images a second while somebody interacts

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

using Images = std::vector<vtkSmartPointer<vtkImageData>>;

Images TimesOf(vtkImageData* image, int times)
{
  Images images;
  for (int time = 0; time < times; ++time)
  {
    images.push_back(MovedByRows(image, time));
  }
  return images;
}

std::vector<double> MsOfStillFrames(OffscreenView& view)
{
  std::vector<double> still;
  for (int frame = 0; frame < StillFrames; ++frame)
  {
    view.Pipeline().Renderer()->GetActiveCamera()->Azimuth(1.0);
    still.push_back(1000.0 * view.Render());
  }
  return still;
}

void PlayInViewer(OffscreenView& view, const Images& images, TimesCost& cost)
{
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
  view.SetPicturesPerSecond(RateInViewer);
  std::vector<double> moving;
  std::vector<double> apart;
  for (const auto& image : images)
  {
    view.Pipeline().SetImage(image);
    moving.push_back(1000.0 * view.Render());
    apart.push_back(mapper->GetUsedImageSampleDistance());
  }
  cost.movingMs = Median(moving);
  cost.movingRaysApart = Median(apart);
}

}

TimesCost CostOfTimes(const Scene& scene, const LoadedVolume& volume, int times, int frames,
  const std::function<void(int)>& onFrame)
{
  const Images images = TimesOf(volume.image, times);
  OffscreenView view(scene, images.front(), MapperKind::Varimarch);
  ScenePipeline& pipeline = view.Pipeline();
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(pipeline.Mapper());
  view.Render();
  TimesCost cost;
  cost.stillMs = Median(MsOfStillFrames(view));
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
  cost.newMs = Median(ofNew);
  cost.againMs = again.empty() ? 0.0 : Median(again);
  cost.fieldMs = Median(ofFields);
  cost.residentMegabytesAtEnd = ResidentMegabytes();
  PlayInViewer(view, images, cost);
  return cost;
}

}
