#include "Tolerance/AccuracyNotes.h"

#include "Core/Geometry/TriangleTree.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"
#include "March/RayMarcher.h"
#include "March/RayParametersBuilder.h"
#include "March/SkyParameters.h"
#include "Resources/ValueFocus.h"
#include "vtkVariationFieldVolumeMapper.h"

#include <optional>
#include <sstream>
#include <string>

namespace varimarch
{

namespace
{

using Error = AccuracyNote::Error;
using Note = std::optional<AccuracyNote>;

struct PlannedImage
{
  const Frame& frame;
  const MarchPlan& plan;
  SceneResources& resources;

  /// True if a condition holds for the march of any volume.
  template <class Condition>
  bool Any(const Condition& condition) const
  {
    bool holds = condition(MarchOf(this->frame, this->plan), this->resources.First());
    for (std::size_t i = 0; i < this->frame.others.size(); ++i)
    {
      holds =
        holds || condition(MarchOfOther(this->frame, this->plan, i), this->resources.Other(i));
    }
    return holds;
  }
};

Note NoteIf(bool holds, Error error, const std::string& sentence)
{
  return holds ? Note({ error, sentence }) : std::nullopt;
}

// Why shaders march, which cannot draw all light.
constexpr const char* ReasonForShaders =
  "packets of rays on the processor are off (ProcessorMarching) or cannot draw this scene. ";

Note MissedCurve(const PlannedImage& image)
{
  return NoteIf(image.resources.MissesCurve(), Error::Unknown,
    "The image may be wrong by any amount: the transfer function changes over such a range of "
    "values that its table misses parts of it. Let its last nodes be among the values to be "
    "seen. ");
}

Note MergedValues(const PlannedImage& image)
{
  return NoteIf(image.resources.MergesValues(), Error::Unknown,
    "The image may be wrong by any amount: all values count in a sum or mean, and they reach so "
    "far that those between which the opacity changes look the same. Replace far values, such as "
    "a fill value, or draw a mean of a range without them. ");
}

Note MissingShadows(const PlannedImage& image)
{
  return NoteIf(image.frame.settings.shadows && image.resources.IsInBlocks(), Error::Known,
    std::string("The volume has no shadows, because it does not fit into the graphics memory at "
                "once, and ") +
      ReasonForShaders + "Allow more graphics memory, or draw a smaller volume. ");
}

Note MissingOcclusion(const PlannedImage& image)
{
  const bool isMissing = IsInWayOfSky(image.frame.settings) &&
    image.plan.marcher == Marcher::Device && image.resources.IsInBlocks();
  return NoteIf(isMissing, Error::Known,
    std::string("The volume has no ambient occlusion, because it does not fit into the graphics "
                "memory at once, and ") +
      ReasonForShaders);
}

Note MissingCasters(const PlannedImage& image)
{
  return NoteIf(image.frame.casters.areTooMany, Error::Known,
    "Opaque geometry casts no shadows, because it has more than " +
      std::to_string(TriangleTree::MostTriangles) +
      " triangles. Simplify it, or let parts of it cast none (CASTS_SHADOWS). ");
}

Note LongShadowSteps(const PlannedImage& image)
{
  return NoteIf(HasLongShadowSteps(MarchOf(image.frame, image.plan)), Error::UnknownLight,
    "The shadows may be wrong by any amount: without a graphics card OpenGL ends the short "
    "segments of rays to lights that the sample distance asks for. Let the processor march "
    "(ProcessorMarching), or switch the shadows off. ");
}

// A shader asks for light in the middle of a sample. Where light and sight end in front of that,
// the sample is black, whatever the sample distance is; so are voxels without interpolation, which
// have one sample. Packets divide such samples (Core/Packets/GatheredLight.h).
bool DarkensDenseMatter(const VolumeMarch& march, VolumeResources& volume)
{
  // Steps can be as short as 1/128 of a voxel, and then have an optical depth of a quarter.
  constexpr double MostDepthOfVoxel = 30.0;
  constexpr double MostDepthOfBox = 1.0;
  const bool isInShadows = march.plan.marcher == Marcher::Device && IsInWayOfLights(march.settings);
  const double depth = volume.Materials().MostExtinction() * SmallestSpacingMm(march.frame);
  return isInShadows && depth >= (march.settings.nearest ? MostDepthOfBox : MostDepthOfVoxel);
}

Note DarkDenseMatter(const PlannedImage& image)
{
  return NoteIf(image.Any(DarkensDenseMatter), Error::UnknownLight,
    std::string("Matter that is dense within a voxel may be drawn too dark in its own shadow, "
                "because ") +
      ReasonForShaders + "Let it absorb less, or switch the shadows off. ");
}

// Matter of opacity 1 ends light within less than any step.
bool IsOpaqueInShadow(const VolumeMarch& march, VolumeResources& volume)
{
  return IsInWayOfLights(march.settings) && !march.settings.nearest &&
    !OpaqueValuesOf(march.frame, volume.Blocks().Texels()).empty();
}

Note OpaqueMatterInShadow(const PlannedImage& image)
{
  return NoteIf(image.Any(IsOpaqueInShadow), Error::UnknownLight,
    "Single pixels at the edges of shadows may have any light, because matter of opacity 1 ends "
    "light within less than a step. Let the opacity stay below 1, as 0.999, or switch the shadows "
    "off. ");
}

Note FewSkyPlaces(const PlannedImage& image)
{
  const auto areFew = [](const VolumeMarch& march, VolumeResources& volume)
  { return HasFewSkyPlaces(march, volume.Light().Sky(march)); };
  return NoteIf(image.Any(areFew), Error::UnknownLight,
    "The ambient occlusion behind translucent matter may be wrong by any amount: without a "
    "graphics card OpenGL ends the rays to all sides before all of their places have them. Let "
    "the processor march (ProcessorMarching), shorten the reach, or switch the occlusion off. ");
}

}

std::vector<AccuracyNote> AccuracyNotesOf(
  const Frame& frame, const MarchPlan& plan, SceneResources& resources)
{
  const PlannedImage image{ frame, plan, resources };
  std::vector<AccuracyNote> notes;
  for (Note (*const find)(const PlannedImage&) :
    { MissedCurve, MergedValues, MissingShadows, MissingOcclusion, MissingCasters, LongShadowSteps,
      DarkDenseMatter, OpaqueMatterInShadow, FewSkyPlaces })
  {
    if (const Note note = find(image))
    {
      notes.push_back(*note);
    }
  }
  return notes;
}

namespace
{

// @param where  the part of the image, after a blank, or nothing
std::string ExceededTolerance(double tolerance, const StepChoice& step, const char* where)
{
  std::ostringstream text;
  text << "The error tolerance " << tolerance
       << (step.isOfBoundedWork ? " is not reached" : " cannot be kept") << where
       << (step.isOfBoundedWork
              ? ", because the light of shorter steps takes too long; allow a larger error"
              : "")
       << ": with a sample every " << step.sampleDistance;
  if (step.error > tolerance)
  {
    text << ", 99.9 % of the pixels are off by up to " << step.error << ". ";
  }
  else
  {
    text << ", isolated pixels exceed it, though 99.9 % of the pixels keep it. ";
  }
  return text.str();
}

}

std::string AccuracyWarnings(vtkVariationFieldVolumeMapper* mapper, const RayMarcher& marcher)
{
  std::string warnings;
  if (!mapper->GetAutoAdjustSampleDistances() &&
    marcher.UsedSampleDistanceMm() > marcher.WantedSampleDistanceMm())
  {
    std::ostringstream text;
    text << "The sample distance " << marcher.WantedSampleDistanceMm()
         << " is too short for this volume: " << marcher.UsedSampleDistanceMm() << " is used. ";
    warnings += text.str();
  }
  for (const AccuracyNote& note : marcher.Notes())
  {
    const bool isTold = note.error != AccuracyNote::Error::UnknownLight || marcher.FoundStep();
    warnings += isTold ? note.sentence : "";
  }
  if (marcher.FoundStep() && !marcher.FoundStep()->KeepsLimit())
  {
    warnings += ExceededTolerance(mapper->GetErrorTolerance(), *marcher.FoundStep(), "");
  }
  if (marcher.FoundStepOfLight() && !marcher.FoundStepOfLight()->KeepsLimit())
  {
    warnings += ExceededTolerance(mapper->GetErrorTolerance(), *marcher.FoundStepOfLight(),
      " in the shadows on opaque geometry");
  }
  return warnings;
}

}
