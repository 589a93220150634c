#include "March/AccuracyWarnings.h"

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
