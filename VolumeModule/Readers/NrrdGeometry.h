#ifndef Varimarch_Readers_NrrdGeometry_h
#define Varimarch_Readers_NrrdGeometry_h

#include "Readers/ImageGeometry.h"
#include "Readers/NrrdAxes.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Determines the geometry. Adds warnings if the file does not state the patient's orientation, or
/// states a unit that is not known.
/// @throws std::runtime_error for an unknown space or invalid numbers
ImageGeometry GeometryOf(
  const NrrdHeader& header, const NrrdAxes& axes, std::vector<std::string>& warnings);

}

#endif
