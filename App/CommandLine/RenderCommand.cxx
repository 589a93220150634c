#include "Commands.h"

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

void RunRender(const RenderArguments& arguments)
{
  const auto [scene, volume] = LoadScene(arguments.scene);
  const Progress progress("Drawing " + arguments.outputPath);
  OffscreenView view(scene, volume.image, arguments.renderer);
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
  WriteResults(results, arguments.jsonPath);
}

}
