#ifndef Varimarch_Readers_Magnitude_h
#define Varimarch_Readers_Magnitude_h

#include "Readers/VolumeFile.h"

#include <string>

namespace varimarch
{

/// Replaces the components of each voxel by their magnitude, the root of the sum of their squares,
/// as a float or, for components of more than 24 bits, a double. Adds a warning.
/// @param reason  beginning of the warning, such as "The numbers are complex"
void TakeMagnitude(const std::string& reason, Volume& volume);

}

#endif
