// MRC and CCP4 maps of electron microscopy and crystallography: a header of 1024 bytes, an extended
// header, then the voxels. See https://www.ccpem.ac.uk/mrc_format/mrc2014.php
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

constexpr std::size_t mrcHeaderBytes = 1024;
constexpr double mmPerAngstrom = 1e-7;

/// The file axis, 0 to 2, along each axis of the cell; the header counts from 1. Files without this
/// entry store x, y, z. Damaged entries may give any number from -1.
glm::ivec3 CellAxes(const BinaryHeader& header)
{
  const glm::ivec3 axes(header.VectorAt<int>(64));
  return axes == glm::ivec3(0) ? glm::ivec3(0, 1, 2) : glm::max(axes, 0) - 1;
}

/// The stamp of the machine that wrote the file is often missing, so the byte order is that in
/// which the entries make sense.
bool IsPlausible(const BinaryHeader& header)
{
  const int mode = header.At<int>(12);
  bool seen[3] = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cellAxis = CellAxes(header)[axis];
    if (cellAxis < 0 || cellAxis > 2 || seen[cellAxis])
    {
      return false;
    }
    seen[cellAxis] = true;
  }
  return mode >= 0 && mode <= 101 && header.At<int>(0) > 0 && header.At<int>(4) > 0 &&
    header.At<int>(8) > 0;
}

VoxelLayout LayoutOf(const std::string& path, const BinaryHeader& header)
{
  VoxelLayout layout = { { header.At<int>(0), header.At<int>(4), header.At<int>(8) }, VTK_VOID };
  // Files of IMOD have a stamp, and a flag for signed bytes.
  const bool isOfImod = header.At<int>(152) == 1146047817;
  const bool hasSignedBytes = !isOfImod || header.At<int>(156) % 2 == 1;
  switch (header.At<int>(12))
  {
    case 0:
      layout.scalarType = hasSignedBytes ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
      break;
    case 1:
      layout.scalarType = VTK_SHORT;
      break;
    case 2:
      layout.scalarType = VTK_FLOAT;
      break;
    case 6:
      layout.scalarType = VTK_UNSIGNED_SHORT;
      break;
    case 16:
      layout.scalarType = VTK_UNSIGNED_CHAR;
      layout.componentCount = 3;
      break;
    default:
      FailToRead(path, "the mode 0, 1, 2, 6 or 16 (real numbers or colours)",
        "the mode " + std::to_string(header.At<int>(12)));
  }
  return layout;
}

/// The edges of the crystal's cell [angstrom]: a along x, b in the plane of x and y.
glm::dmat3 CellEdges(const BinaryHeader& header)
{
  const glm::dvec3 length = header.VectorAt<float>(40);
  glm::dvec3 angle = glm::radians(header.VectorAt<float>(52));
  for (int axis = 0; axis < 3; ++axis)
  {
    angle[axis] = angle[axis] > 0.0 ? angle[axis] : glm::radians(90.0);
  }
  const glm::dvec3 cosine = glm::cos(angle);
  const double sineGamma = std::sin(angle.z);
  const double y = (cosine.x - cosine.y * cosine.z) / sineGamma;
  const double z = std::sqrt(std::max(0.0, 1.0 - cosine.y * cosine.y - y * y));
  return { { length.x, 0.0, 0.0 }, glm::dvec3(cosine.z, sineGamma, 0.0) * length.y,
    glm::dvec3(cosine.y, y, z) * length.z };
}

/// The number of volumes of equal depth that follow each other. The space group 0 means images, 1 a
/// volume, and 401 to 630 a stack of volumes with as many slices each as there are intervals.
std::int64_t VolumeCountOf(const std::string& path, const BinaryHeader& header)
{
  const int group = header.At<int>(88);
  const int slices = header.At<int>(8);
  const int each = header.At<int>(36);
  if (group < 401 || group > 630)
  {
    return 1;
  }
  if (each < 1 || slices % each != 0)
  {
    FailToRead(path,
      "a number of slices that its volumes (space group " + std::to_string(group) +
        ") share evenly",
      std::to_string(slices) + " slices in volumes of " + std::to_string(each));
  }
  return slices / each;
}

/// Warns of images that are no slices of a volume, such as those of single particles.
void WarnOfImages(const BinaryHeader& header, std::vector<std::string>& warnings)
{
  const int count = header.At<int>(8);
  if (header.At<int>(88) == 0 && header.At<int>(36) == 1 && count > 1)
  {
    warnings.push_back("The file says that it is a stack of " + std::to_string(count) +
      " images (space group 0), not a volume; they were read as slices.");
  }
}

/// Adds a warning if the file does not state the size of its voxels.
ImageGeometry GeometryOf(const BinaryHeader& header, Volume& volume)
{
  const glm::dvec3 intervals = header.VectorAt<int>(28);
  const glm::dvec3 lengths = header.VectorAt<float>(40);
  const bool hasSize = glm::all(glm::greaterThan(intervals, glm::dvec3(0.0))) &&
    glm::all(glm::greaterThan(lengths, glm::dvec3(0.0)));
  if (!hasSize)
  {
    volume.warnings.push_back(UnknownSpacing);
    return ImageGeometry();
  }
  const glm::dmat3 edges = CellEdges(header);
  const glm::ivec3 cellAxes = CellAxes(header);
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = edges[cellAxes[axis]] / intervals[cellAxes[axis]];
  }
  // Programs for electron microscopy state the origin, others the index of the first voxel.
  const glm::dvec3 origin = header.VectorAt<float>(196);
  geometry.originMm =
    origin != glm::dvec3(0.0) ? origin : geometry.axesMm * header.VectorAt<int>(16);
  return InLps(geometry, glm::dvec3(1.0), mmPerAngstrom);
}

}

bool IsMrc(const std::string& head)
{
  return head.size() >= 212 && head.compare(208, 3, "MAP") == 0;
}

Volume ReadMrc(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const BinaryHeader little(path, mrcHeaderBytes, false);
  const BinaryHeader big(little.Bytes(), true);
  if (!IsPlausible(little) && !IsPlausible(big))
  {
    FailToRead(path, "an MRC header with a size, a mode and an order of axes", "other numbers");
  }
  const BinaryHeader& header = IsPlausible(little) ? little : big;
  VoxelFile file;
  file.paths = { path };
  file.compression = CompressionOf(path);
  file.bigEndian = &header == &big;
  const int extendedBytes = header.At<int>(92);
  if (extendedBytes < 0)
  {
    FailToRead(path, "an extended header of at least 0 bytes", std::to_string(extendedBytes));
  }
  file.dataOffset = std::int64_t(mrcHeaderBytes) + extendedBytes;

  Volume volume;
  const ImageGeometry geometry = GeometryOf(header, volume);
  VoxelLayout layout = LayoutOf(path, header);
  file.volumeCount = VolumeCountOf(path, header);
  layout.dimensions[2] /= file.volumeCount;
  TakeTimes(path, NumberedTimes(file.volumeCount), options, volume);
  file.volume = options.time;
  file.kept = StreamOf(options);
  volume.image = ReadVoxels(file, layout, progress);
  PlaceImage(path, geometry, volume.image);
  WarnOfImages(header, volume.warnings);
  return volume;
}

}
