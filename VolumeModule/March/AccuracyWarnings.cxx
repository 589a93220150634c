#include "March/AccuracyWarnings.h"

#include "Core/Geometry/TriangleTree.h"
#include "March/RayMarcher.h"
#include "vtkVariationFieldVolumeMapper.h"

#include <sstream>
#include <string>

namespace varimarch
{

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

// Why shaders march, which cannot draw all light.
constexpr const char* ReasonForShaders =
  "packets of rays on the processor are off (ProcessorMarching) or cannot draw this scene. ";

// The light that an image lacks.
std::string WarningsOfMissingLight(const RayMarcher& marcher)
{
  std::string warnings;
  if (marcher.LeavesOutShadows())
  {
    warnings +=
      "The volume has no shadows, because it does not fit into the graphics memory at once, and ";
    warnings += ReasonForShaders;
    warnings += "Allow more graphics memory, or draw a smaller volume. ";
  }
  if (marcher.LeavesOutOcclusion())
  {
    warnings +=
      "The volume has no ambient occlusion, because it does not fit into the graphics memory at "
      "once, and ";
    warnings += ReasonForShaders;
  }
  if (marcher.LeavesOutCasters())
  {
    warnings += "Opaque geometry casts no shadows, because it has more than " +
      std::to_string(TriangleTree::MostTriangles) +
      " triangles. Simplify it, or let parts of it cast none (CASTS_SHADOWS). ";
  }
  return warnings;
}

// The light that no trial of an error tolerance judges.
std::string WarningsOfUnknownLight(const RayMarcher& marcher)
{
  std::string warnings;
  if (marcher.HasLongShadowSteps())
  {
    warnings += "The shadows may be wrong by any amount: without a graphics card OpenGL ends the "
                "short segments of rays to lights that the sample distance asks for. Let the "
                "processor march (ProcessorMarching), or switch the shadows off. ";
  }
  if (marcher.DarkensDenseMatter())
  {
    warnings += "Matter that is dense within a voxel may be drawn too dark in its own shadow, "
                "because ";
    warnings += ReasonForShaders;
    warnings += "Let it absorb less, or switch the shadows off. ";
  }
  if (marcher.HasOpaqueMatterInShadow())
  {
    warnings +=
      "Single pixels at the edges of shadows may have any light, because matter of opacity 1 "
      "ends light within less than a step. Let the opacity stay below 1, as 0.999, or switch "
      "the shadows off. ";
  }
  if (marcher.HasFewSkyPlaces())
  {
    warnings += "The ambient occlusion behind translucent matter may be wrong by any amount: "
                "without a graphics card OpenGL ends the rays to all sides before all of their "
                "places have them. Let the processor march (ProcessorMarching), shorten the reach, "
                "or switch the occlusion off. ";
  }
  return warnings;
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
  if (marcher.MissesCurve())
  {
    warnings += "The image may be wrong by any amount: the transfer function changes over such a "
                "range of values that its table misses parts of it. Let its last nodes be among "
                "the values to be seen. ";
  }
  if (marcher.MergesValues())
  {
    warnings += "The image may be wrong by any amount: all values count in a sum or mean, and they "
                "reach so far that those between which the opacity changes look the same. Replace "
                "far values, such as a fill value, or draw a mean of a range without them. ";
  }
  warnings += WarningsOfMissingLight(marcher);
  warnings += marcher.FoundStep() ? WarningsOfUnknownLight(marcher) : "";
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
