#ifndef Varimarch_Readers_NiftiGeometry_h
#define Varimarch_Readers_NiftiGeometry_h

#include "Readers/ImageGeometry.h"
#include "Readers/NiftiHeader.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The geometry in LPS [mm]: the header's affine form (sform), or else its quaternion form (qform),
/// or else only the size of a voxel. For Analyze it is that of SPM, if the header or a file .mat
/// states one.
/// @param path  path of the header
/// @param warnings  receives sentences about forms that are invalid or contradict each other
ImageGeometry GeometryOf(
  const std::string& path, const NiftiHeader& header, std::vector<std::string>& warnings);

}

#endif
