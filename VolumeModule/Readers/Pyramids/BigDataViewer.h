#ifndef Varimarch_Readers_Pyramids_BigDataViewer_h
#define Varimarch_Readers_Pyramids_BigDataViewer_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace varimarch
{

/// The file of voxels that a description of BigDataViewer (.xml) names; any other path is returned
/// as it is.
/// @throws std::runtime_error if the description names no file in HDF5
std::string FileOfBigDataViewer(const std::string& path);

/// Size of a voxel as the description beside a file says, which has its name with ".xml" [mm].
/// @param setup  the number of the volume, from 0
/// @param warnings  receives a sentence if there is no description, or it does not say the size
/// @throws std::runtime_error if the description is damaged
glm::dvec3 BigDataViewerVoxelMm(
  const std::string& voxelFile, std::size_t setup, std::vector<std::string>& warnings);

}

#endif
