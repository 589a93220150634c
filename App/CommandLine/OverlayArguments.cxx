#include "OverlayArguments.h"

#include "LabelArguments.h"
#include "Messages.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/Placing.h"
#include "UsageError.h"
#include "VolumeArguments.h"

namespace varimarch
{

namespace
{

// Volumes of scenes may have no name.
std::string NameOf(const OverlaidVolume& overlay)
{
  const auto* const file = std::get_if<FileSource>(&overlay.source);
  return overlay.name.empty() ? (file ? file->path : "a further volume") : overlay.name;
}

// A volume that has been placed by hand or by registration has its place whatever its file says.
void WarnOfOtherSpace(
  const LoadedVolume& first, const LoadedVolume& volume, const OverlaidVolume& overlay)
{
  const CommonSpace space = SpaceOf(first, volume);
  if (space == CommonSpace::Same || !(overlay.placement == Placement()))
  {
    return;
  }
  PrintMessage("warning: " + NameOf(overlay) +
    (space == CommonSpace::Different
        ? " has another frame of reference than the first volume, so it may lie in the wrong place"
        : ": the files do not say whether it is in the same space as the first volume; it is "
          "placed by its coordinates"));
}

}

std::vector<OverlayVoxels> LoadOverlaysReporting(
  const std::vector<std::string>& paths, const LoadedVolume& first, Scene& scene)
{
  if (1 + scene.overlays.size() + paths.size() > MostVolumes)
  {
    throw UsageError("--overlay: expected at most " + std::to_string(MostVolumes) +
      " volumes together with the first, found " +
      std::to_string(1 + scene.overlays.size() + paths.size()));
  }
  std::vector<OverlayVoxels> voxels;
  for (OverlaidVolume& overlay : scene.overlays)
  {
    const LoadedVolume volume = LoadVolumeReporting(overlay.source);
    WarnOfOtherSpace(first, volume, overlay);
    voxels.push_back({ volume.image });
    if (overlay.labels)
    {
      voxels.back().labels = LoadLabelsReporting(volume, *overlay.labels);
    }
  }
  for (const std::string& path : paths)
  {
    const FileSource source = { path, std::nullopt };
    const LoadedVolume volume = LoadVolumeReporting(source);
    scene.overlays.push_back(OverlayOf(source, volume, ImageStatistics(volume.image)));
    WarnOfOtherSpace(first, volume, scene.overlays.back());
    voxels.push_back({ volume.image });
  }
  return voxels;
}

}
