#ifndef Varimarch_Readers_Images_TiffDescription_h
#define Varimarch_Readers_Images_TiffDescription_h

#include "Readers/Images/TiffFile.h"
#include "Readers/Rescale.h"
#include "Readers/VolumeFile.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A page of a set of TIFF files.
struct TiffPlane
{
  std::string path;
  std::size_t page;
};

/// The volume that a TIFF file describes.
struct TiffStack
{
  /// The planes of one time, slice after slice, with the channels of a slice together.
  std::vector<TiffPlane> planes;
  std::size_t channelCount = 1;
  std::vector<VolumeChannel> channels = {}; ///< as many, if the file tells about them
  VolumeTimes times;
  std::array<double, 3> spacingMm = { 0.0, 0.0, 0.0 }; ///< 0 if unknown
  Rescale rescale = {}; ///< from stored values to those that the file means
  std::vector<std::string> warnings;
};

/// The stack that the text of ImageJ describes; nothing if the file has none. Adds the pages that
/// have no directories to the file. See ij.io.FileInfo and ij.io.TiffDecoder of ImageJ.
/// @param time  the time to read; the last one if it is beyond that
/// @throws std::runtime_error for a description that is false
std::optional<TiffStack> ImageJStack(TiffFile& file, std::int64_t time);

/// The stack that the XML of OME-TIFF describes; nothing if the file has none. See
/// https://docs.openmicroscopy.org/ome-model/latest/ome-tiff/specification.html
/// @param time  the time to read; the last one if it is beyond that
/// @throws std::runtime_error for a description that is false
std::optional<TiffStack> OmeStack(const TiffFile& file, std::int64_t time);

/// The stack that the axes of tifffile's description in JSON describe; nothing if the file has
/// none. Adds the pages that have no directories to the file.
/// @param time  the time to read; the last one if it is beyond that
std::optional<TiffStack> ShapedStack(TiffFile& file, std::int64_t time);

/// The stack that MetaMorph's tags describe; nothing if the file has none. Adds the planes, which
/// have no directories, to the file.
/// @param time  the time to read; the last one if it is beyond that
/// @throws std::runtime_error if the planes cannot be found
std::optional<TiffStack> StkStack(TiffFile& file, std::int64_t time);

/// The stack that the tag of Zeiss' microscopes describes; nothing if the file has none.
/// @param time  the time to read; the last one if it is beyond that
std::optional<TiffStack> LsmStack(const TiffFile& file, std::int64_t time);

/// The pages of a file without description, which are slices. Pages of another size than most are
/// left out, with a warning.
TiffStack PlainStack(const TiffFile& file);

}

#endif
