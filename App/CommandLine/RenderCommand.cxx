#include "Commands.h"

#include "Messages.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/ImageFiles.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"
#include "Scene/SceneNames.h"
#include "VtkMessages.h"

#include <vtkVariationFieldVolumeMapper.h>

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

void WarnOfMissingLabels(
  const RenderArguments& arguments, const Scene& scene, const LoadedVolume& volume)
{
  if (scene.labels && !CanDrawLabels(arguments.renderer, scene.look.blend, volume.image))
  {
    PrintMessage(
      "warning: the labels are not drawn: expected the blend mode composite, a volume of "
      "one component, and a renderer other than vtk-cpu; found the blend mode " +
      NameOf(BlendNames(), scene.look.blend) + ", " +
      std::to_string(volume.image->GetNumberOfScalarComponents()) + " components and " +
      NameOf(MapperKindNames(), arguments.renderer));
  }
}

}

void RunRender(const RenderArguments& arguments)
{
  auto [scene, volume] = LoadScene(arguments.scene);
  const auto labels = LoadLabelsReporting(arguments.labels, volume, scene);
  WarnOfMissingLabels(arguments, scene, volume);
  const Progress progress("Drawing " + arguments.outputPath);
  OffscreenView view(scene, volume.image, arguments.renderer);
  view.Pipeline().SetLabels(labels);
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
  if (ours)
  {
    ours->SetMaximumGraphicsMemory(vtkIdType(1e6 * arguments.graphicsMegabytes));
  }
  const double seconds = view.Render();
  std::vector<double> repeatSeconds;
  for (int i = 0; i < arguments.repeats; ++i)
  {
    repeatSeconds.push_back(view.Render());
  }
  ThrowIfVtkReportedError();
  WritePng(view.Bytes(), arguments.outputPath);

  nlohmann::ordered_json results = ResultsOf(arguments.commandText, volume);
  results["look"] = scene.look.name;
  results["size"] = scene.size;
  results["renderer"] = NameOf(MapperKindNames(), arguments.renderer);
  results["sampleDistanceMm"] = view.Pipeline().UsedSampleDistanceMm();
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
  results["picture"] = arguments.outputPath;
  AddSegments(labels, results);
  WriteResults(results, arguments.jsonPath);
}

}
