#include "Commands.h"

#include "Options.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/ImageFiles.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"
#include "Scene/SceneNames.h"
#include "Validators.h"
#include "VtkMessages.h"

#include <vtkVariationFieldVolumeMapper.h>

#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

struct RenderCommand
{
  std::string commandText;
  SceneOptions sceneOptions;
  std::string renderer = "ours";
  std::string outputPath;
  std::string jsonPath;
  double graphicsMegabytes = 0.0;
  int repeats = 0;

  void Run() const
  {
    const auto [scene, volume] = this->sceneOptions.Load();
    const auto progress = std::make_unique<Progress>("Drawing " + this->outputPath);
    OffscreenView view(scene, volume.image, ValueOf(MapperKindNames(), this->renderer));
    auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
    if (ours)
    {
      ours->SetMaximumGraphicsMemory(vtkIdType(1e6 * this->graphicsMegabytes));
    }
    const double seconds = view.Render();
    std::vector<double> repeatSeconds;
    for (int i = 0; i < this->repeats; ++i)
    {
      repeatSeconds.push_back(view.Render());
    }
    ThrowIfVtkReportedError();
    WritePng(view.Bytes(), this->outputPath);

    nlohmann::ordered_json results = ResultsOf(this->commandText, volume);
    const double sampleDistanceMm = view.Pipeline().UsedSampleDistanceMm();
    results["look"] = scene.look.name;
    results["size"] = scene.size;
    results["renderer"] = this->renderer;
    results["sampleDistanceMm"] = sampleDistanceMm;
    results["firstPictureSeconds"] = seconds;
    if (!repeatSeconds.empty())
    {
      results["repeatSeconds"] = Median(repeatSeconds);
    }
    if (ours)
    {
      results["graphicsMemoryBytes"] = ours->GetGraphicsMemoryBytes();
      results["blockUploads"] = ours->GetBlockUploads();
    }
    results["openglRenderer"] = view.DeviceName();
    results["picture"] = this->outputPath;
    WriteResults(results, this->jsonPath);
  }
};

}

void AddRenderCommand(CLI::App& program, const std::string& commandText)
{
  const auto command = std::make_shared<RenderCommand>();
  command->commandText = commandText;
  CLI::App* app = program.add_subcommand("render", "Draw a volume or a scene into a PNG file");
  app->footer(
    "Examples:\n"
    "  varimarch render head.nii.gz -o head.png\n"
    "  varimarch render dicom-folder -o bone.png --preset ct-bone --view left --zoom 1.3\n"
    "  varimarch render scan.raw --raw-dimensions 256x256x128 --raw-type uint16 -o scan.png\n"
    "  varimarch render procedural:torso:256x192x192 -o torso.png --azimuth 30\n"
    "  varimarch render scene.json -o scene.png --size 1024x1024 --renderer vtk-gpu");
  command->sceneOptions.AddTo(*app);
  app->add_option("-o,--output", command->outputPath, "The picture to write")
    ->type_name("FILE.png")
    ->required();
  app->add_option("--renderer", command->renderer, "Who draws (default ours)")
    ->check(NameValidator(NamesOf(MapperKindNames())))
    ->group("Sampling");
  app
    ->add_option("--graphics-memory", command->graphicsMegabytes,
      "Most that our mapper takes, in MB; what does not fit is drawn in blocks (default: all)")
    ->check(CLI::NonNegativeNumber)
    ->group("Sampling");
  app->add_option("--repeat", command->repeats, "Draw so often again, and tell the median time")
    ->check(CLI::NonNegativeNumber)
    ->group("Sampling");
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}
