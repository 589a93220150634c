#ifndef Varimarch_Readers_Formats_MincFile_h
#define Varimarch_Readers_Formats_MincFile_h

#include "Readers/VoxelLayout.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A dimension of the image. Start and step of time are in seconds.
struct MincAxis
{
  std::string name; ///< "xspace", "yspace", "zspace", "time", "vector_dimension" or another
  std::size_t length = 0;
  double startMm = 0.0;
  double stepMm = 1.0;
  bool hasStep = false;              ///< true if the file states the step
  std::optional<glm::dvec3> cosines; ///< direction in RAS; default: the axis of the name
  bool isIrregular = false;
};

/// A part of an array: the first index and the length along each of its axes.
struct MincPart
{
  std::vector<std::size_t> start;
  std::vector<std::size_t> count;
};

/// An open file of MINC 1 (netCDF) or MINC 2 (HDF5), which have the same contents. See
/// https://en.wikibooks.org/wiki/MINC/Reference
class MincFile
{
public:
  virtual ~MincFile() = default;

  /// Reads values of the image into memory of its type.
  virtual void ReadImage(const MincPart& part, void* destination) = 0;

  /// Reads the smallest ("image-min") or largest real value of parts of the image.
  virtual std::vector<double> ReadExtremes(const std::string& name, const MincPart& part) = 0;

  std::vector<MincAxis> axes; ///< dimensions of the image, slowest first
  NumberKind kind = NumberKind::Unsigned;
  std::size_t valueBytes = 0;
  std::optional<std::array<double, 2>> validRange; ///< the stored values of the extremes
  std::size_t extremeRank = 0; ///< number of axes, slowest first, along which extremes vary
  bool hasExtremes = false;
  double storedBytes = 0.0; ///< upper bound of the bytes of the image in the file
  bool isCompressed = false;
};

/// Open a file.
/// @throws std::runtime_error if it is not of the format, or has no image
std::unique_ptr<MincFile> OpenMinc1(const std::string& path);
std::unique_ptr<MincFile> OpenMinc2(const std::string& path);

}

#endif
