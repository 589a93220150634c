#ifndef Varimarch_Readers_Pyramids_ZarrAxes_h
#define Varimarch_Readers_Pyramids_ZarrAxes_h

#include "Readers/ImageGeometry.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Pyramids/ZarrArray.h"
#include "Readers/VolumeFile.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// An axis of an array.
struct ZarrAxis
{
  std::string name;         ///< "x", "channel" or any other
  std::optional<int> world; ///< 0 to 2 for x, y and z; empty for other axes
  bool isChannel = false;
  bool isTime = false;
  double mmPerUnit = 1.0;
  double secondsPerUnit = 0.0; ///< 0 if the unit is not known
  double scale = 1.0;          ///< in the unit of the axis, as the next
  double translation = 0.0;    ///< position of the first voxel's centre
};

using ZarrAxes = std::vector<ZarrAxis>;

/// The axes of an array without metadata: z, y and x are the last.
/// @throws std::runtime_error if there are less than two
ZarrAxes PlainZarrAxes(const std::string& path, std::size_t rank);

/// The axes of a multiscale image, without scale.
/// @param path  path of the metadata, for error messages
/// @param warnings  receives a sentence about units that are not known
/// @throws std::runtime_error if they are not those of an image
ZarrAxes OmeAxes(
  const std::string& path, const nlohmann::json& multiscale, std::vector<std::string>& warnings);

/// Applies a list of scales and translations.
/// @throws std::runtime_error if it has anything else
void ApplyTransforms(const std::string& path, const nlohmann::json& transforms, ZarrAxes& axes);

/// The volume of a channel and a time at the first place along other axes.
/// @throws std::runtime_error if the array has other axes, or no such channel or time
ZarrSelection SelectionOf(const std::string& path, const ZarrAxes& axes, const ZarrHeader& header,
  const ReadOptions& options);

/// The times of an array: those of its axis of time, or else a single one.
VolumeTimes TimesOf(const ZarrAxes& axes, const ZarrHeader& header);

/// Positions of the selected voxels [mm].
ImageGeometry GeometryOf(const ZarrAxes& axes, const ZarrSelection& selection);

/// The sentence that one of several places of an axis was read.
std::string PlaceLeftOut(const ZarrAxis& axis, std::int64_t count, int taken);

/// Sentences about what is not selected along axes of other kinds than space, time and channel.
std::vector<std::string> LeftOut(const ZarrAxes& axes, const ZarrHeader& header);

}

#endif
