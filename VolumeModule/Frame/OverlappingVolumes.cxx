#include "Frame/OverlappingVolumes.h"

#include "Frame/FrameMeasures.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkMultiVolume.h"

#include <algorithm>
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
    { settings.shadows, "shadows" },
    { settings.scattering, "scattering" },
    { settings.occlusion, "ambient occlusion" },
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

// The settings of the image are those of the first volume.
void JoinTo(Frame& first, Frame other)
{
  first.quality.budget.isSampled |= other.quality.budget.isSampled;
  first.settings.jitter = first.settings.jitter || other.settings.jitter;
  other.cuts = { other.geometry.boxGrid, {}, {} };
  other.settings.clipping = false;
  other.settings.jitter = false;
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
  }
  Frame first = std::move(frames.front());
  // Shaders cut all volumes by the planes of the first, so these planes must not reduce its box.
  first.cuts = CutsOf(mapper, first.geometry, true);
  first.settings.clipping = !first.cuts.planesGrid.empty();
  double sampleDistanceMm = first.quality.sampleDistanceMm;
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    sampleDistanceMm = std::min(sampleDistanceMm, frames[i].quality.sampleDistanceMm);
    JoinTo(first, std::move(frames[i]));
  }
  // Without interpolation a ray steps from voxel face to voxel face.
  first.quality.sampleDistanceMm =
    IsSampled(first.settings) ? sampleDistanceMm : LongestRayMm(first);
  return first;
}

}
