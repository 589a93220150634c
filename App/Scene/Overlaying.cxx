#include "Scene/Overlaying.h"

#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/VolumeProperty.h"

#include <filesystem>

namespace varimarch
{

namespace
{

// Projections cannot be drawn together with other volumes.
Look LookOver(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  if (volume.modality == "PT")
  {
    return BuiltInPreset("pet-hot").look;
  }
  Look look = BuiltInPreset(SuggestedPreset(volume, statistics).name).look;
  return look.blend == Blend::Composite ? look : BuiltInPreset("mr-head").look;
}

}

CommonSpace SpaceOf(const LoadedVolume& first, const LoadedVolume& other)
{
  if (first.frameOfReference.empty() || other.frameOfReference.empty())
  {
    return CommonSpace::Unknown;
  }
  return first.frameOfReference == other.frameOfReference ? CommonSpace::Same
                                                          : CommonSpace::Different;
}

OverlaidVolume OverlayOf(
  const VolumeSource& source, const LoadedVolume& volume, const ImageStatistics& statistics)
{
  OverlaidVolume overlay = { source, InUnitsOfData(LookOver(volume, statistics), statistics) };
  if (const auto* const file = std::get_if<FileSource>(&source))
  {
    const std::filesystem::path path = file->path;
    overlay.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  }
  overlay.name = volume.modality + (volume.modality.empty() ? "" : " ") + overlay.name;
  overlay.sliceColors = volume.modality == "PT" ? SliceColors::Hot : SliceColors::Gray;
  return overlay;
}

}
