#include "Benchmark.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/SceneArguments.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Median.h"
#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>

namespace varimarch
{

namespace
{

/// The cost of voxels that are new in each frame, as when the times of a scan are played.
struct TimesCost
{
  int frames = 0;
  double stillMs = 0.0; ///< median time of a frame of the same voxels from another side
  double newMs = 0.0;   ///< median time of a frame of voxels that were not drawn before
  double againMs = 0.0; ///< median time of a frame of other voxels that were; 0 without any
  double fieldMs = 0.0; ///< median time for the field of new voxels, a part of the former
  double residentMegabytesAtFirst =
    0.0; ///< memory of the process when each time, or frame, was drawn once
  double residentMegabytesAtEnd = 0.0;
  double movingMs = 0.0;        ///< median time of a frame while somebody plays, as in the viewer
  double movingRaysApart = 1.0; ///< median distance between the rays of these frames [pixels]
};

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

// Renders a volume at several times, each of which differs from the last by the values of a few
// rows of voxels that move.
// @param times  at least 2
// @param onFrame  called after each frame with its number
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

struct TimesOptions
{
  SceneArguments scene;
  std::string input;
  int times = 20;
  int frames = 1000;
};

void AddTimesOptions(CLI::App& command, TimesOptions& options)
{
  AddSceneArgument(command, options.input);
  AddLookAndPictureOptions(command, options.scene);
  command.add_option("--times", options.times, "Number of times (default 20)")
    ->check(CLI::Range(2, 1000).description(""))
    ->type_name("N");
  command.add_option("--frames", options.frames, "Number of frames (default 1000)")
    ->check(CLI::Range(1, 100000000).description(""))
    ->type_name("N");
}

void RunTimes(const TimesOptions& options, BenchResults& results)
{
  const auto [scene, volume] = LoadScene(options.scene, options.input);
  Progress progress("Rendering " + std::to_string(options.frames) + " frames");
  const TimesCost cost = CostOfTimes(scene, volume, options.times, options.frames,
    [&](int frame) { progress.SetActivity(std::to_string(frame) + " frames rendered"); });
  results.json.update(
    { { "times", options.times }, { "frames", cost.frames }, { "newMs", cost.newMs },
      { "againMs", cost.againMs }, { "fieldMs", cost.fieldMs }, { "stillMs", cost.stillMs },
      { "movingMs", cost.movingMs }, { "movingRaysApart", cost.movingRaysApart },
      { "residentMegabytesAtFirst", cost.residentMegabytesAtFirst },
      { "residentMegabytesAtEnd", cost.residentMegabytesAtEnd } });
  results.Write("all frames");
}

}

Benchmark TimesBenchmark()
{
  return MakeBenchmark("times",
    "Play the times of a scan: other voxels in every frame; watch memory and speed",
    "Example:\n"
    "  varimarch-bench times procedural:torso:256x256x256 -o report --size 512x512",
    AddTimesOptions, RunTimes);
}

}
