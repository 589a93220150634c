#ifndef Varimarch_Readers_SpmMatrix_h
#define Varimarch_Readers_SpmMatrix_h

#include "Readers/ImageGeometry.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The geometry in RAS [mm] of an Analyze header, from the file .mat that SPM99 and SPM2 write
/// beside it: a MATLAB file of version 4 with a matrix "mat" or "M" that maps voxels, counted from
/// 1, to mm. Nothing if there is no such file.
/// @param warnings  receives a sentence about a file that has no such matrix
std::optional<ImageGeometry> SpmMatrixBeside(
  const std::string& headerPath, std::vector<std::string>& warnings);

}

#endif
