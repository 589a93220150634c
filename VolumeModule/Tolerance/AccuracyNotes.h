#ifndef Varimarch_Tolerance_AccuracyNotes_h
#define Varimarch_Tolerance_AccuracyNotes_h

#include "Frame/MarchPlan.h"
#include "Resources/SceneResources.h"

#include <string>
#include <vector>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

class RayMarcher;

/// A shortcoming of an image.
struct AccuracyNote
{
  enum class Error
  {
    Known,       ///< trial images show it, or a part of the scene is left out
    Unknown,     ///< the image may be wrong by any amount, which no trial image shows
    UnknownLight ///< the same, of light; the sentence is told only with an error tolerance
  };
  Error error;
  std::string sentence; ///< one or two sentences, which end with what helps
};

/// The shortcomings of an image that is planned.
/// @param resources  those of the frame, up to date
std::vector<AccuracyNote> AccuracyNotesOf(
  const Frame& frame, const MarchPlan& plan, SceneResources& resources);

/// Sentences about the accuracy that the last frame lacks; empty if it lacks none.
std::string AccuracyWarnings(vtkVariationFieldVolumeMapper* mapper, const RayMarcher& marcher);

}

#endif
