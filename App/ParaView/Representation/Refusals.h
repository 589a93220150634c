#ifndef Varimarch_Refusals_h
#define Varimarch_Refusals_h

#include "OwnedPart.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The settings of a volume whose image cannot always be composed of parts.
struct Request
{
  int blendMode = 0;       ///< a blend mode of vtkVolumeMapper
  bool dimsLight = false;  ///< true if light is dimmed by what it has passed
  bool isCropped = false;  ///< true if only a box of the volume is drawn
  bool isShared = false;   ///< true if several processes have a part of the volume each
  bool hasSeveral = false; ///< true if the input is a data set of several parts
};

/// A sentence that says why the parts of a volume cannot be drawn. It is the same on all processes,
/// since several are always refused what several parts are. Empty if they can.
std::string ProblemOfRequest(const Request& request, const std::vector<OwnedPart>& parts);

/// A sentence that says why the parts of this process cannot be drawn in any order; empty if they
/// can.
std::string ProblemOfParts(const std::vector<OwnedPart>& parts);

}

#endif
