// NIfTI-1 in one file, optionally gzipped. See https://nifti.nimh.nih.gov/nifti-1
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include <vtkNIFTIPrivate.h>

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr std::size_t niftiHeaderBytes = 352; ///< with four bytes that say that nothing follows
constexpr int scannerCoordinates = 1;
constexpr int millimetres = 2;
constexpr int vectorIntent = 1007;

/// The data type if the components of a voxel are a colour; 0 otherwise.
int ColourType(const WrittenImage& image)
{
  const bool isBytes = image.Type().scalarType == VTK_UNSIGNED_CHAR;
  const int count = image.ComponentCount();
  return !isBytes ? 0 : count == 3 ? NIFTI_TYPE_RGB24 : count == 4 ? NIFTI_TYPE_RGBA32 : 0;
}

bool HasVectors(const WrittenImage& image)
{
  return image.ComponentCount() > 1 && ColourType(image) == 0;
}

nifti_1_header HeaderOf(const std::string& path, const WrittenImage& image)
{
  nifti_1_header header = {};
  header.sizeof_hdr = 348;
  header.dim[0] = HasVectors(image) ? 5 : 3;
  std::fill(header.dim + 1, header.dim + 8, short(1));
  std::fill(header.pixdim, header.pixdim + 8, 1.0f);
  const glm::dvec3 lpsFromRas(-1.0, -1.0, 1.0);
  float* const rows[3] = { header.srow_x, header.srow_y, header.srow_z };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = image.Size()[std::size_t(axis)];
    if (size > std::numeric_limits<short>::max())
    {
      throw std::runtime_error(path +
        ": expected at most 32767 voxels along each axis, as NIfTI "
        "allows, found " +
        std::to_string(size) + "; NRRD has no such limit");
    }
    header.dim[axis + 1] = short(size);
    header.pixdim[axis + 1] = float(image.SpacingMm()[axis]);
    const glm::dvec3 stepMm = lpsFromRas * image.Direction()[axis] * image.SpacingMm()[axis];
    for (int row = 0; row < 3; ++row)
    {
      rows[row][axis] = float(stepMm[row]);
      rows[row][3] = float(lpsFromRas[row] * image.OriginMm()[row]);
    }
  }
  header.sform_code = scannerCoordinates;
  header.xyzt_units = millimetres;
  header.scl_slope = 1.0f;
  header.vox_offset = float(niftiHeaderBytes);
  header.datatype = short(ColourType(image) != 0 ? ColourType(image) : image.Type().nifti);
  header.bitpix = short(
    8 * image.ValueBytes() * std::size_t(ColourType(image) != 0 ? image.ComponentCount() : 1));
  if (HasVectors(image))
  {
    header.dim[5] = short(image.ComponentCount());
    header.intent_code = vectorIntent;
  }
  std::memcpy(header.magic, "n+1", 4);
  return header;
}

/// A file that is compressed with gzip or not.
class GzipFile
{
public:
  GzipFile(const std::string& path, bool isCompressed)
    : file(gzopen(path.c_str(), isCompressed ? "wb6" : "wbT"))
  {
  }
  ~GzipFile()
  {
    if (this->file)
    {
      gzclose(this->file);
    }
  }
  GzipFile(const GzipFile&) = delete;
  void operator=(const GzipFile&) = delete;

  /// Does nothing after a failure.
  void Write(const char* bytes, std::size_t count)
  {
    constexpr std::size_t mostBytes = 1 << 26;
    while (this->isGood && count > 0)
    {
      const auto part = unsigned(std::min(count, mostBytes));
      this->isGood = this->file && gzwrite(this->file, bytes, part) == int(part);
      bytes += part;
      count -= part;
    }
  }

  /// Closes the file. @returns false if anything has failed
  bool Finish()
  {
    const bool isClosed = this->file && gzclose(this->file) == Z_OK;
    this->file = nullptr;
    return isClosed && this->isGood;
  }

private:
  gzFile file;
  bool isGood = true;
};

/// Writes one component of all voxels.
void WriteComponent(const WrittenImage& image, int component, GzipFile& file)
{
  const std::size_t valueBytes = image.ValueBytes();
  const std::size_t voxelBytes = valueBytes * std::size_t(image.ComponentCount());
  const char* const values = image.Values() + std::size_t(component) * valueBytes;
  std::string plane;
  plane.reserve(image.VoxelCount() * valueBytes);
  for (std::size_t voxel = 0; voxel < image.VoxelCount(); ++voxel)
  {
    plane.append(values + voxel * voxelBytes, valueBytes);
  }
  file.Write(plane.data(), plane.size());
}

}

bool WriteNiftiFile(const LoadedVolume& volume, const std::string& path, bool isCompressed)
{
  const WrittenImage image(path, volume.image);
  const nifti_1_header header = HeaderOf(path, image);
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(header));
  bytes.resize(niftiHeaderBytes);
  GzipFile file(path, isCompressed);
  file.Write(bytes.data(), bytes.size());
  if (HasVectors(image))
  {
    for (int component = 0; component < image.ComponentCount(); ++component)
    {
      WriteComponent(image, component, file);
    }
  }
  else
  {
    image.EachPiece([&](const char* values, std::size_t count) { file.Write(values, count); });
  }
  return file.Finish();
}

}
