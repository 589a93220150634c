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

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

/// One of the equal parts of a long run.
struct SoakPart
{
  int frames;               ///< number of frames since the start of the run
  double medianMs;          ///< median time of the part's frames
  double residentMegabytes; ///< memory of the process at the end of the part
  int openFiles;            ///< open files of the process at the end of the part
  int threads;              ///< threads of the process at the end of the part
};

constexpr int SoakParts = 10;

int OpenFiles()
{
  return int(std::distance(
    std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator()));
}

/// A scene in a window, and the changes that a working day makes to it.
class Day
{
public:
  Day(const Scene& scene, vtkImageData* image)
    : scene(scene)
    , image(vtkSmartPointer<vtkImageData>::New())
  {
    this->image->ShallowCopy(image);
    vtkDataArray* const values = image->GetPointData()->GetScalars();
    for (vtkSmartPointer<vtkDataArray>& moment : this->moments)
    {
      moment.TakeReference(values->NewInstance());
      moment->DeepCopy(values);
    }
    ShiftValues(this->moments[1]);
    this->view = std::make_unique<OffscreenView>(scene, this->image, MapperKind::Varimarch);
  }

  /// Renders a frame and returns its time [ms].
  double Frame(int number)
  {
    ScenePipeline& pipeline = this->view->Pipeline();
    pipeline.Renderer()->GetActiveCamera()->Azimuth(1.0);
    if (number % 10 == 0)
    {
      Look look = this->scene.look;
      look.opacityUnitDistanceMm *= number % 20 == 0 ? 1.0 : 1.25;
      pipeline.SetLook(look);
    }
    if (number % 50 == 0)
    {
      this->image->GetPointData()->SetScalars(this->moments[number / 50 % 2]);
      this->image->Modified();
    }
    if (number % 200 == 0)
    {
      SceneCuts cuts = this->scene.cuts;
      if (number % 400 == 0)
      {
        cuts.box = { 0.2, 0.9, 0.0, 0.8, 0.1, 1.0 };
      }
      pipeline.SetCuts(cuts);
    }
    return 1000.0 * this->view->Render();
  }

private:
  /// Moves all values by one voxel, as if the patient had breathed.
  static void ShiftValues(vtkDataArray* values)
  {
    const vtkIdType count = values->GetNumberOfTuples();
    for (vtkIdType voxel = 0; voxel + 1 < count; ++voxel)
    {
      values->SetTuple(voxel, voxel + 1, values);
    }
  }

  Scene scene;
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkDataArray> moments[2];
  std::unique_ptr<OffscreenView> view;
};

// Renders a scene as a long working day does: each frame is seen from another side, every tenth has
// another look, every 50th other voxels, and every 200th other cuts.
// @param frames  at least SoakParts
// @param onPart  called after each part
void Soak(const Scene& scene, const LoadedVolume& volume, int frames,
  const std::function<void(const SoakPart&)>& onPart)
{
  Day day(scene, volume.image);
  int parts = 0;
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame)
  {
    times.push_back(day.Frame(frame));
    if (frame == int(std::int64_t(frames) * (parts + 1) / SoakParts))
    {
      ++parts;
      onPart(
        { frame, Median(times), ResidentMegabytes(), OpenFiles(), int(StatusNumber("Threads")) });
      times.clear();
    }
  }
}

struct SoakOptions
{
  SceneArguments scene;
  std::string input;
  int frames = 20000; ///< at least SoakParts
};

void AddSoakOptions(CLI::App& command, SoakOptions& options)
{
  AddSceneArgument(command, options.input);
  AddLookAndPictureOptions(command, options.scene);
  command.add_option("--frames", options.frames, "Number of frames (default 20000)")
    ->check(CLI::Range(SoakParts, 100000000).description(""))
    ->type_name("N");
}

void RunSoak(const SoakOptions& options, BenchResults& results)
{
  const auto [scene, volume] = LoadScene(options.scene, options.input);
  Progress progress("Rendering " + std::to_string(options.frames) + " frames");
  Soak(scene, volume, options.frames,
    [&](const SoakPart& part)
    {
      results.json["parts"].push_back({ { "frames", part.frames }, { "medianMs", part.medianMs },
        { "residentMegabytes", part.residentMegabytes }, { "openFiles", part.openFiles },
        { "threads", part.threads } });
      const std::string frames = std::to_string(part.frames) + " frames";
      results.Write(frames);
      progress.SetActivity(frames + " of " + std::to_string(options.frames) + " rendered");
    });
}

}

Benchmark SoakBenchmark()
{
  return MakeBenchmark("soak",
    "Render for a long time, with edits and other voxels, and watch memory and speed",
    "Examples:\n"
    "  varimarch-bench soak head.nii.gz -o report\n"
    "  varimarch-bench soak procedural:torso:128x128x96 -o report --frames 100000",
    AddSoakOptions, RunSoak);
}

}
