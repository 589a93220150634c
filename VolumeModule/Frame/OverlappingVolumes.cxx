#include "Frame/OverlappingVolumes.h"

#include "Frame/FrameMeasures.h"
#include "Frame/NumberCheck.h"
#include "Frame/SceneFingerprint.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkMultiVolume.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

struct Exclusion
{
  bool isUsed;
  const char* name;
};

// Throws std::runtime_error if a feature is requested that overlapping volumes do not have.
void CheckTogether(const Frame& frame, vtkVariationFieldVolumeMapper* mapper)
{
  const RenderSettings& settings = frame.settings;
  const Exclusion exclusions[] = {
    { settings.blend != Blend::Composite, "a blend mode other than composite" },
    { settings.mask != Mask::None, "a mask" },
    { mapper->GetCropping() != 0, "cropping" },
    { settings.clippedGradients, "cuts drawn as surfaces" },
    { frame.voxels.blanking.Any(), "blanked voxels" },
    { !frame.userCode.IsEmpty(), "user shader code" },
    { frame.span.mostSteps > 0, "a number of steps" },
    { settings.countFetches, "fetch counts" },
    { settings.pass == RayPass::PickVoxel, "a selection of points or cells" },
    { frame.image.toImages, "a depth image" },
  };
  for (const Exclusion& exclusion : exclusions)
  {
    if (exclusion.isUsed)
    {
      throw std::runtime_error(
        std::string("Overlapping volumes cannot be drawn with ") + exclusion.name);
    }
  }
}

bool IsAny(const std::vector<Frame>& frames, bool RenderSettings::*choice)
{
  return std::any_of(
    frames.begin(), frames.end(), [&](const Frame& frame) { return frame.settings.*choice; });
}

// Everything that the light from all around depends on, in all volumes.
Fingerprint OccludersOf(const std::vector<Frame>& frames)
{
  Fingerprint occluders;
  for (const Frame& frame : frames)
  {
    occluders.Add(Fingerprint(ExtinctionFingerprint(frame), frame.geometry.worldFromGrid));
  }
  return occluders;
}

// The opaque geometry that lit volumes have found, which is the same for all.
void ShareCasters(std::vector<Frame>& frames)
{
  const auto found = std::find_if(
    frames.begin(), frames.end(), [](const Frame& frame) { return frame.settings.shadows; });
  for (auto frame = frames.begin(); frame != frames.end() && found != frames.end(); ++frame)
  {
    frame->casters = found->casters;
    frame->settings.casters = found->settings.casters;
  }
}

// Light from all around goes through all volumes, and equally far through each.
void ShareSky(std::vector<Frame>& frames)
{
  const bool areOccluded = IsAny(frames, &RenderSettings::occlusion);
  MaterialRequest shared = frames.front().material;
  shared.occludersMm = 0.0;
  for (const Frame& frame : frames)
  {
    const MaterialRequest& own = frame.material;
    shared.occlusionReachMm = std::min(shared.occlusionReachMm, own.occlusionReachMm);
    shared.occluderVoxelMm = std::min(shared.occluderVoxelMm, own.occluderVoxelMm);
    shared.occludersMm += own.occludersMm;
  }
  const Fingerprint occluders = areOccluded ? OccludersOf(frames) : Fingerprint();
  for (Frame& frame : frames)
  {
    frame.settings.occludesOthers = areOccluded;
    frame.material.occlusionReachMm = shared.occlusionReachMm;
    frame.material.occluderVoxelMm = shared.occluderVoxelMm;
    frame.material.occludersMm = shared.occludersMm;
    frame.quality.budget.isOccluded = areOccluded;
    frame.occluders = occluders;
  }
}

// Light from lamps goes through all volumes, and equally far through each.
void ShareLight(std::vector<Frame>& frames)
{
  const bool areInShadow = IsAny(frames, &RenderSettings::shadows);
  double shadowReachMm = 0.0;
  for (const Frame& frame : frames)
  {
    shadowReachMm = std::max(shadowReachMm, frame.material.shadowReachMm);
  }
  for (Frame& frame : frames)
  {
    frame.settings.shadowsOthers = areInShadow;
    frame.material.shadowReachMm = shadowReachMm;
  }
  ShareCasters(frames);
}

// The planes of all volumes, which must not reduce the box of one.
void KeepPlanes(Frame& frame, vtkVariationFieldVolumeMapper* mapper)
{
  NumberCheck known; // the volume has told of its planes already
  frame.cuts = CutsOf(mapper, frame.geometry, true, known);
  frame.settings.clipping = !frame.cuts.planesGrid.empty();
}

// The settings of the image are those of the first volume.
void JoinTo(Frame& first, Frame other)
{
  first.quality.budget.isSampled |= other.quality.budget.isSampled;
  first.settings.jitter = first.settings.jitter || other.settings.jitter;
  if (!IsInWayOfLights(other.settings) && !IsInWayOfSky(other.settings))
  {
    other.cuts = { other.geometry.boxGrid, {}, {} }; // rays of the eye are cut in the first
    other.settings.clipping = false;
  }
  other.settings.jitter = false;
  std::copy_if(other.replacedNumbers.begin(), other.replacedNumbers.end(),
    std::back_inserter(first.replacedNumbers),
    [&](const std::string& sentence) {
      return std::count(first.replacedNumbers.begin(), first.replacedNumbers.end(), sentence) == 0;
    });
  first.settings.others.push_back(other.settings);
  first.others.push_back(std::move(other));
}

}

std::vector<VolumeOfPort> VolumesOfPorts(vtkVariationFieldVolumeMapper* mapper, vtkVolume* prop)
{
  auto* const several = vtkMultiVolume::SafeDownCast(prop);
  if (!several)
  {
    return { { 0, prop } };
  }
  std::vector<VolumeOfPort> volumes;
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    vtkVolume* const volume =
      mapper->GetNumberOfInputConnections(port) > 0 ? several->GetVolume(port) : nullptr;
    if (volume)
    {
      volumes.push_back({ port, volume });
    }
  }
  return volumes;
}

Frame JoinFrames(std::vector<Frame> frames, vtkVariationFieldVolumeMapper* mapper)
{
  for (Frame& frame : frames)
  {
    CheckTogether(frame, mapper);
    frame.settings.overlaps = true;
    frame.quality.budget.volumeCount = int(frames.size());
    frame.quality.choosesIntegration = false;
    KeepPlanes(frame, mapper);
  }
  ShareLight(frames);
  ShareSky(frames);
  Frame first = std::move(frames.front());
  double sampleDistanceMm = first.quality.sampleDistanceMm;
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    sampleDistanceMm = std::min(sampleDistanceMm, frames[i].quality.sampleDistanceMm);
    JoinTo(first, std::move(frames[i]));
  }
  // Without interpolation a ray steps from voxel face to voxel face, but light is sampled.
  const bool hasSamples =
    IsSampled(first.settings) || IsInWayOfLights(first.settings) || IsInWayOfSky(first.settings);
  first.quality.sampleDistanceMm = hasSamples ? sampleDistanceMm : LongestRayMm(first);
  return first;
}

}
