#include "Frame/OverlappingVolumes.h"

#include "Core/Recipe/ShaderRecipe.h"

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

// Throws a sentence for what several volumes are not drawn with.
void CheckTogether(const Frame& frame, vtkVariationFieldVolumeMapper* mapper)
{
  const RenderSettings& settings = frame.settings;
  const Exclusion exclusions[] = {
    { settings.blend != Blend::Composite, "another blend mode than composite" },
    { settings.mask != Mask::None, "a mask" },
    { mapper->GetCropping() != 0, "cropping" },
    { settings.clippedGradients, "cuts that are seen as surfaces" },
    { frame.blanking.Any(), "blanked voxels" },
    { !frame.userCode.IsEmpty(), "code of one's own in the shader" },
    { settings.countFetches, "counts of fetches" },
    { settings.pass == RayPass::PickVoxel, "a selection of their voxels" },
    { frame.toImages, "an image of their depth" },
  };
  for (const Exclusion& exclusion : exclusions)
  {
    if (exclusion.isUsed)
    {
      throw std::runtime_error(
        std::string("Volumes that overlap are not drawn with ") + exclusion.name);
    }
  }
}

// What is the picture's is the first volume's.
void JoinTo(Frame& first, Frame other)
{
  first.errorTolerance = std::max(first.errorTolerance, other.errorTolerance);
  first.settings.jitter = first.settings.jitter || other.settings.jitter;
  other.cuts = { other.geometry.boxGrid, {}, {} };
  other.settings.clipping = false;
  other.settings.jitter = false;
  first.settings.others.push_back(other.settings);
  first.others.push_back(std::move(other));
}

template <class Number>
double SumOf(const Frame& frame, const Number& numberOf)
{
  double sum = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    sum += numberOf(other.geometry);
  }
  return sum;
}

template <class Number>
double SmallestOf(const Frame& frame, const Number& numberOf)
{
  double smallest = numberOf(frame.geometry);
  for (const Frame& other : frame.others)
  {
    smallest = std::min(smallest, numberOf(other.geometry));
  }
  return smallest;
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

Frame JoinedFrame(std::vector<Frame> frames, vtkVariationFieldVolumeMapper* mapper)
{
  for (Frame& frame : frames)
  {
    CheckTogether(frame, mapper);
    frame.settings.overlaps = true;
    frame.fieldError /= double(frames.size());
    frame.chooseIntegration = false;
  }
  Frame first = std::move(frames.front());
  // In the shader the planes of the first volume are those of all; its box stays its own.
  first.cuts = CutsOf(mapper, first.geometry, true);
  first.settings.clipping = !first.cuts.planesGrid.empty();
  double sampleDistanceMm = first.sampleDistanceMm;
  for (std::size_t i = 1; i < frames.size(); ++i)
  {
    sampleDistanceMm = std::min(sampleDistanceMm, frames[i].sampleDistanceMm);
    JoinTo(first, std::move(frames[i]));
  }
  // Where nothing is sampled, the faces of voxels are the steps.
  first.sampleDistanceMm = IsSampled(first.settings) ? sampleDistanceMm : LongestRayMm(first);
  return first;
}

double SmallestSpacingMm(const Frame& frame)
{
  return SmallestOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.SmallestSpacingMm(); });
}

double ThinnestSideMm(const Frame& frame)
{
  return SmallestOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.ThinnestSideMm(); });
}

double LongestRayMm(const Frame& frame)
{
  return SumOf(frame, [](const VolumeGeometry& geometry) { return geometry.DiagonalMm(); });
}

double ShortestSampleDistanceMm(const Frame& frame)
{
  const double sumMm = SumOf(
    frame, [](const VolumeGeometry& geometry) { return geometry.ShortestSampleDistanceMm(); });
  if (frame.marcher == Marcher::Processor)
  {
    // Nothing ends its loops; of more samples some would be where rounding puts them.
    constexpr double TimesAsMany = 4.0;
    return sumMm / TimesAsMany;
  }
  // One volume takes three rounds for a segment; several two, and two for each of them. A lit
  // one is searched for what is visible by a loop in which pixels wait for each other: five rounds
  // in some pictures, and there may be worse.
  constexpr double RoundsOfOne = 3.0;
  constexpr double RoundsOfLit = 6.0;
  const bool isLit = MarchesMaterial(frame.settings);
  const double volumes = 1.0 + double(frame.others.size());
  const double rounds = volumes > 1.0 ? 2.0 + 2.0 * volumes : (isLit ? RoundsOfLit : RoundsOfOne);
  return sumMm * rounds / RoundsOfOne;
}

// As many as a ray along the diagonal takes at the sample distance, and as many as the faces of
// cells it can pass.
int MostSegmentsOf(const Frame& frame)
{
  const double steps = std::ceil(LongestRayMm(frame) / frame.sampleDistanceMm);
  int most = int(steps);
  const auto add = [&](const Frame& one)
  { most += one.geometry.dimensions.x + one.geometry.dimensions.y + one.geometry.dimensions.z; };
  add(frame);
  std::for_each(frame.others.begin(), frame.others.end(), add);
  return most;
}

}
