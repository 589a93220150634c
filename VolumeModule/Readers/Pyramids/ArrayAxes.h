#ifndef Varimarch_Readers_Pyramids_ArrayAxes_h
#define Varimarch_Readers_Pyramids_ArrayAxes_h

#include "Readers/ImageGeometry.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/VolumeFile.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The axes of an array in which a volume lies, and its place along the others.
struct ArraySelection
{
  static constexpr std::size_t NoAxis = std::size_t(-1);

  /// For each axis of the volume in memory, the fastest first, the axis of the array; NoAxis for
  /// one that the array does not have, with a single voxel.
  std::array<std::size_t, 3> axes;
  std::vector<std::int64_t> start; ///< the index along each axis of the array
};

/// An axis of an array.
struct ArrayAxis
{
  std::string name;         ///< "x", "channel" or any other
  std::optional<int> world; ///< the axis of the world that it lies along, 0 to 2; or empty
  double sign = 1.0;        ///< -1 if it points the other way
  bool isChannel = false;
  bool isTime = false;
  double mmPerUnit = 1.0;
  double secondsPerUnit = 0.0; ///< 0 if the unit is not known
  double scale = 1.0;          ///< in the unit of the axis, as the next
  double translation = 0.0;    ///< position of the first voxel's centre
};

using ArrayAxes = std::vector<ArrayAxis>;

/// The axes of an array of which at most the names are known, slowest first. Those with names of
/// other kinds, and without names, are the axes of space that no name means, of which x is the
/// last.
/// @param names  one for each axis, which may be empty
/// @throws std::runtime_error if there are less than two
ArrayAxes AxesNamed(const std::string& path, const std::vector<std::string>& names);

/// The axes of a multiscale image, without scale. The orientations of RFC-4, if the file states
/// all, say along which axes of the patient they lie.
/// @param path  path of the metadata, for error messages
/// @param warnings  receives a sentence about units that are not known, and about unknown sides
/// @throws std::runtime_error if they are not those of an image
ArrayAxes OmeAxes(
  const std::string& path, const nlohmann::json& multiscale, std::vector<std::string>& warnings);

/// Applies a list of scales and translations.
/// @throws std::runtime_error if it has anything else
void ApplyTransforms(const std::string& path, const nlohmann::json& transforms, ArrayAxes& axes);

/// Places an axis by its coordinates, and adds a sentence if they are not evenly spaced.
/// @param unit  of length, or of time for an axis of time
/// @returns false, and changes nothing, if they do not say how long a step is
bool PlaceAxis(const std::vector<double>& coordinates, const std::string& unit, ArrayAxis& axis,
  std::vector<std::string>& warnings);

/// The volume of a channel and a time at the first place along other axes.
/// @param shape  the lengths of the axes
/// @param isFortran  true if the first index runs fastest
/// @throws std::runtime_error if the array has other axes, or no such channel or time
ArraySelection SelectionOf(const std::string& path, const ArrayAxes& axes,
  const std::vector<std::int64_t>& shape, bool isFortran, const ReadOptions& options);

/// Positions of the selected voxels [mm].
ImageGeometry GeometryOf(const ArrayAxes& axes, const ArraySelection& selection);

/// Takes the times and the channels of an array, and adds sentences about what is not selected.
/// More channels than components of a voxel are not named.
/// @param channel  the channel that is read
void DescribeAxes(
  const ArrayAxes& axes, const std::vector<std::int64_t>& shape, int channel, PyramidForm& form);

}

#endif
