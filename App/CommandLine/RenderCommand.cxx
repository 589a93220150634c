#include "Commands.h"

#include "ArgumentChecks.h"
#include "Messages.h"
#include "OverlayArguments.h"
#include "Progress.h"
#include "ReportedErrors.h"
#include "Results.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Median.h"
#include "UsageError.h"

#include <vtkVariationFieldVolumeMapper.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

bool AreDrawnTogether(const RenderArguments& arguments, const Scene& scene)
{
  return CanOverlay(arguments.renderer) &&
    std::any_of(scene.overlays.begin(), scene.overlays.end(),
      [](const OverlaidVolume& overlay) { return overlay.visible; });
}

// Labels of several volumes are volumes themselves.
void WarnOfMissingLabels(
  const RenderArguments& arguments, const Scene& scene, const LoadedVolume& volume)
{
  if (AreDrawnTogether(arguments, scene))
  {
    if (!AreAllSegmentsDrawn(scene))
    {
      PrintMessage("warning: not all labels are drawn: expected at most " +
        std::to_string(MostVolumes) + " volumes, of which each with labels counts twice");
    }
  }
  else if (scene.labels && !CanDrawLabels(arguments.renderer, scene.look.blend, volume.image))
  {
    PrintMessage(
      "warning: the labels are not drawn: expected the blend mode composite, a volume of "
      "one component, and a renderer other than vtk-cpu; found the blend mode " +
      NameOf(BlendNames(), scene.look.blend) + ", " +
      std::to_string(volume.image->GetNumberOfScalarComponents()) + " components and " +
      NameOf(MapperKindNames(), arguments.renderer));
  }
}

// Several volumes are marched as one composite.
void WarnOfMissingTogether(const RenderArguments& arguments, const Scene& scene)
{
  if (scene.overlays.empty())
  {
    return;
  }
  if (!CanOverlay(arguments.renderer))
  {
    PrintMessage("warning: only the first volume is drawn: vtk-cpu draws one");
  }
  else if (scene.look.blend != Blend::Composite)
  {
    PrintMessage("warning: several volumes are drawn as composites");
  }
}

// Warns of labels and regions that are not drawn.
void WarnOfMissingParts(
  const RenderArguments& arguments, const Scene& scene, const LoadedVolume& volume)
{
  WarnOfMissingLabels(arguments, scene, volume);
  WarnOfMissingTogether(arguments, scene);
  if (!scene.look.regions.empty() &&
    !CanDrawRegions(arguments.renderer, scene.look.blend, volume.image))
  {
    PrintMessage("warning: the regions of the look are not drawn, but its curves: expected the "
                 "blend mode composite, a volume of one component, and a renderer other than "
                 "vtk-cpu");
  }
}

// Rejects an output that cannot be written, before a volume is read for it. A DICOM file may be
// part of a scan, so it is not replaced by mistake.
void CheckOutput(const RenderArguments& arguments)
{
  const std::string& path = arguments.outputPath;
  const auto format = PictureFormatOf(path);
  if (!format)
  {
    throw UsageError("--output: expected a name that ends with .png or .dcm, found " + path);
  }
  if (*format == PictureFormat::Dicom)
  {
    CheckMayReplace(path, arguments.overwrites);
  }
}

/// Limits the memory of our mapper; null for a mapper of VTK.
vtkVariationFieldVolumeMapper* LimitedMapper(OffscreenView& view, double graphicsMegabytes)
{
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
  if (ours)
  {
    ours->SetMaximumGraphicsMemory(vtkIdType(1e6 * graphicsMegabytes));
  }
  return ours;
}

// Adds what only our mapper knows. It does not know that its volume is a preview.
void AddDrawing(
  vtkVariationFieldVolumeMapper* ours, bool isPreview, nlohmann::ordered_json& results)
{
  if (ours)
  {
    results["graphicsMemoryBytes"] = ours->GetGraphicsMemoryBytes();
    results["levelErrorBound"] = isPreview ? 1.0 : ours->GetLevelErrorBound();
    if (ours->GetVisibleBlocks() > 0)
    {
      results["visibleBlocks"] = ours->GetVisibleBlocks();
      results["refinedBlocks"] = ours->GetRefinedBlocks();
    }
    results["blockUploads"] = ours->GetBlockUploads();
  }
}

// Says what an image that takes voxels only where it needs them has of them.
void TellOfLevel(vtkVariationFieldVolumeMapper* ours, double seconds)
{
  if (!ours || ours->GetLevelOfDetail() != vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    return;
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  if (ours->GetUsedLevelOfDetail() == vtkVariationFieldVolumeMapper::CoarseLevel)
  {
    text << "the coarse level after " << seconds << " s";
    PrintMessage(text.str());
  }
  else if (ours->GetUsedLevelOfDetail() == vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    text << "voxels of " << ours->GetRefinedBlocks() << " of " << ours->GetVisibleBlocks()
         << " visible blocks after " << seconds
         << " s: the coarse level of the others changes the image by at most "
         << std::setprecision(4) << ours->GetLevelErrorBound();
    if (ours->GetDrawnPart() < 1.0 && !ours->GetNextRefinementFits())
    {
      text
        << "; the voxels of the next image may not fit in the memory, so that it is the last one, "
           "and takes long";
    }
    PrintMessage(text.str());
  }
}

// Says which lengths stand for relative ones, and warns of an image without anything in it.
void TellOfLook(const Scene& scene, OffscreenView& view)
{
  const double drawnMm = view.Pipeline().DrawnLook().opacityUnitDistanceMm;
  if (drawnMm != scene.look.opacityUnitDistanceMm)
  {
    std::ostringstream text;
    text
      << "the volume is not known to show a patient, so the lengths of the look follow its size: "
         "opacities hold over "
      << drawnMm << " mm";
    PrintMessage(text.str());
  }
  const std::string reason = view.ReasonForNothing(scene);
  if (!reason.empty())
  {
    PrintMessage("warning: nothing is visible: " + reason);
  }
}

}

void RunRender(const RenderArguments& arguments)
{
  CheckOutput(arguments);
  auto [scene, volume] =
    LoadScene(arguments.scene, arguments.scene.volume.input, arguments.labels.path.empty());
  const auto labels = LoadLabelsReporting(arguments.labels, volume, scene);
  const auto overlays = LoadOverlaysReporting(arguments.overlays, volume, scene);
  WarnOfMissingParts(arguments, scene, volume);
  const Progress progress("Drawing " + arguments.outputPath);
  OffscreenView view(scene, volume.image, arguments.renderer);
  view.Pipeline().SetLabels(labels);
  view.Pipeline().SetOverlays(scene.overlays, overlays);
  auto* const ours = LimitedMapper(view, arguments.graphicsMegabytes);
  const double seconds = view.RenderAll([&](double now) { TellOfLevel(ours, now); });
  std::vector<double> repeatSeconds;
  for (int i = 0; i < arguments.repeats; ++i)
  {
    repeatSeconds.push_back(view.Render());
  }
  ThrowIfVtkReportedError();
  TellOfLook(scene, view);
  WritePicture(view.Bytes(), { scene.render, arguments.renderer, {}, {}, volume.isPreview },
    arguments.outputPath);

  nlohmann::ordered_json results = ResultsOf(arguments.commandText, volume);
  results["look"] = scene.look.name;
  results["opacityUnitDistanceMm"] = view.Pipeline().DrawnLook().opacityUnitDistanceMm;
  results["size"] = scene.size;
  results["renderer"] = NameOf(MapperKindNames(), arguments.renderer);
  results["sampleDistanceMm"] = view.Pipeline().UsedSampleDistanceMm();
  results["firstPictureSeconds"] = seconds;
  if (!repeatSeconds.empty())
  {
    results["repeatSeconds"] = Median(repeatSeconds);
  }
  AddDrawing(ours, volume.isPreview, results);
  results["openglRenderer"] = view.DeviceName();
  results["picture"] = arguments.outputPath;
  AddSegments(labels, results);
  WriteResults(results, arguments.jsonPath);
}

}
