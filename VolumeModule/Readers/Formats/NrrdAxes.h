#ifndef Varimarch_Readers_Formats_NrrdAxes_h
#define Varimarch_Readers_Formats_NrrdAxes_h

#include "Readers/Parsing/HeaderText.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace varimarch
{

/// The fields of an NRRD header. Keys are lower case without spaces ("spacedirections").
struct NrrdHeader
{
  std::string path;
  HeaderFields fields;
  std::map<std::string, std::string> pairs; ///< the lines "key:=value", which programs define
  std::vector<std::string> listedFiles;     ///< the lines after "data file: LIST"
  std::uint64_t end = 0;                    ///< file offset of the first byte after the header
};

/// @throws std::runtime_error if the file is not an NRRD file, or its header is incomplete
NrrdHeader ReadNrrdHeader(const std::string& path);

/// The parts of a field's value: words, vectors "(x, y, z)" and quoted strings.
std::vector<std::string> NrrdParts(const std::string& value);

/// The parts of the first of these fields that exists, one for each axis; empty if there is none.
/// @throws std::runtime_error for another number of parts
std::vector<std::string> NrrdPartsPerAxis(
  const NrrdHeader& header, const std::vector<std::string>& keys, std::size_t axisCount);

/// The numbers of a vector such as "(1,0,0)"; empty for "none" and for vectors of NaN, which teem
/// writes for axes without direction.
/// @param what  description of the vector for the error message
/// @throws std::runtime_error for any other text
std::vector<double> NrrdVector(
  const NrrdHeader& header, const std::string& what, const std::string& text);

/// The text without spaces, since NRRD allows both "data file" and "datafile".
std::string WithoutBlanks(std::string text);

/// The role of each axis of an NRRD file.
struct NrrdAxes
{
  std::vector<std::int64_t> sizes;
  std::vector<std::size_t> spatial; ///< at most three axes of the volume, fastest first
  std::int64_t volumeCount = 1;     ///< number of time points or list elements
  std::vector<std::size_t> lists;   ///< axes of these volumes, fastest first
  bool areAlternating = false;      ///< the volumes alternate voxel by voxel, instead of one by one
  std::int64_t componentCount = 1;  ///< values per voxel
  bool planar = false;     ///< components are stored one after another, each for the whole volume
  bool areComplex = false; ///< the components are a real and an imaginary part
};

/// Determines the axes.
/// @throws std::runtime_error for axes that do not form a volume
NrrdAxes AxesOf(const NrrdHeader& header);

/// The times of the volumes: in seconds if the header has their distance with its unit, or if they
/// are those of a 3D Slicer's multi-volume.
VolumeTimes TimesOf(const NrrdHeader& header, const NrrdAxes& axes);

/// @throws std::runtime_error for an unknown scalar type
VoxelLayout LayoutOf(const NrrdHeader& header, const NrrdAxes& axes);

}

#endif
