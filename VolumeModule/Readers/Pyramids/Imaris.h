#ifndef Varimarch_Readers_Pyramids_Imaris_h
#define Varimarch_Readers_Pyramids_Imaris_h

#include "Readers/ImageGeometry.h"
#include "Readers/VolumeFile.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

class Hdf5File;

/// The corners of the volume of an Imaris file [mm].
struct ImarisBox
{
  glm::dvec3 lowest;
  glm::dvec3 highest;
};

/// @param warnings  receives a sentence if the unit of the file is not known
/// @throws std::runtime_error if the file does not state the corners
ImarisBox ImarisBoxOf(const Hdf5File& file, std::vector<std::string>& warnings);

/// The number of voxels along x, y and z as the group of a channel states it.
/// @throws std::runtime_error if it does not
std::array<std::int64_t, 3> ImarisDimensions(const Hdf5File& file, const std::string& group);

/// Positions of as many voxels as fill the box.
ImageGeometry ImarisGeometry(const ImarisBox& box, const std::array<std::int64_t, 3>& dimensions);

/// The times of an Imaris file, which says when each was scanned, counted from 1; numbers if it
/// does not.
VolumeTimes ImarisTimes(const Hdf5File& file, std::size_t count);

/// The names and colours of two to four channels; empty for others, which are not read together.
std::vector<VolumeChannel> ImarisChannels(const Hdf5File& file, std::size_t count);

}

#endif
