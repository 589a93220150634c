#ifndef Varimarch_Readers_Pyramids_Hdf5Layouts_h
#define Varimarch_Readers_Pyramids_Hdf5Layouts_h

#include "Readers/ImageGeometry.h"
#include "Readers/Pyramids/ArrayAxes.h"
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

class Hdf5File;

/// The name of the data set with the most numbers among those with three axes or more.
/// @throws std::runtime_error if there is none
std::string LargestDataSet(const Hdf5File& file);

/// The axes of a data set as ilastik, Fiji, h5py and netCDF-4 describe them, slowest first: placed
/// by their scales, or else with the sizes of a voxel.
/// @param warnings  receives sentences about sizes that are not known, and scales that are not even
/// @throws std::runtime_error if there is no such data set, or it has less than two axes
ArrayAxes AxesOfDataSet(
  const Hdf5File& file, const std::string& name, std::vector<std::string>& warnings);

}

#endif
