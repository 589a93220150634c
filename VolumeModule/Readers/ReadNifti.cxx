// NIfTI-1 and NIfTI-2: one file (.nii), or a header (.hdr) with the voxels in a second file (.img),
// optionally gzipped. See https://nifti.nimh.nih.gov/nifti-1 and /nifti-2.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Rescale.h"
#include "Readers/VoxelFile.h"

#include <vtkByteSwap.h>
#include <vtkNIFTIPrivate.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

/// The content of both header versions, in host byte order.
struct NiftiHeader
{
  bool bigEndian;
  bool isOneFile;
  std::int64_t dim[8]; ///< [0] is the number of dimensions that follow
  int datatype;
  double pixdim[8]; ///< [0] is the sign of the third axis in the quaternion form
  double voxelOffset;
  Rescale rescale;
  double calibration[2]; ///< smallest and largest value to show
  int units;
  int quaternionCode;
  int affineCode;
  double quaternion[3];
  double quaternionOffset[3];
  double affine[3][4]; ///< rows of the affine matrix
};

/// Reads header fields of either byte order.
struct FieldReader
{
  bool swaps;

  template <class From, class To>
  void Take(From from, To& to) const
  {
    if (this->swaps)
    {
      vtkByteSwap::SwapVoidRange(&from, 1, sizeof(from));
    }
    to = To(from);
  }

  template <class From, class To, std::size_t Count>
  void Take(const From (&from)[Count], To (&to)[Count]) const
  {
    for (std::size_t i = 0; i < Count; ++i)
    {
      this->Take(from[i], to[i]);
    }
  }
};

/// @tparam Stored  nifti_1_header or nifti_2_header, whose fields have the same names
template <class Stored>
NiftiHeader HeaderFromBytes(const char* bytes, const FieldReader& fields)
{
  Stored stored;
  std::memcpy(&stored, bytes, sizeof(stored));
  NiftiHeader header = {};
  header.isOneFile = stored.magic[1] == '+';
  fields.Take(stored.dim, header.dim);
  fields.Take(stored.datatype, header.datatype);
  fields.Take(stored.pixdim, header.pixdim);
  fields.Take(stored.vox_offset, header.voxelOffset);
  fields.Take(stored.scl_slope, header.rescale.slope);
  fields.Take(stored.scl_inter, header.rescale.intercept);
  fields.Take(stored.cal_min, header.calibration[0]);
  fields.Take(stored.cal_max, header.calibration[1]);
  fields.Take(stored.xyzt_units, header.units);
  fields.Take(stored.qform_code, header.quaternionCode);
  fields.Take(stored.sform_code, header.affineCode);
  fields.Take(stored.quatern_b, header.quaternion[0]);
  fields.Take(stored.quatern_c, header.quaternion[1]);
  fields.Take(stored.quatern_d, header.quaternion[2]);
  fields.Take(stored.qoffset_x, header.quaternionOffset[0]);
  fields.Take(stored.qoffset_y, header.quaternionOffset[1]);
  fields.Take(stored.qoffset_z, header.quaternionOffset[2]);
  fields.Take(stored.srow_x, header.affine[0]);
  fields.Take(stored.srow_y, header.affine[1]);
  fields.Take(stored.srow_z, header.affine[2]);
  return header;
}

NiftiHeader ReadHeader(const std::string& path)
{
  ReadableFileSize(path);
  char bytes[sizeof(nifti_2_header)] = {};
  const std::size_t got = OpenStream(path, CompressionOf(path))->Read(bytes, sizeof(bytes));
  const bool is1 =
    std::memcmp(bytes + 344, "n+1", 4) == 0 || std::memcmp(bytes + 344, "ni1", 4) == 0;
  const bool is2 = std::memcmp(bytes + 4, "n+2", 4) == 0 || std::memcmp(bytes + 4, "ni2", 4) == 0;
  if (!is1 && !is2)
  {
    FailToRead(path, "a NIfTI header with the mark n+1, ni1, n+2 or ni2",
      got < sizeof(nifti_1_header) ? std::to_string(got) + " bytes" : "another mark");
  }
  // sizeof does not apply, because compilers pad the end of nifti_2_header.
  const std::size_t needed = is1 ? 348 : 540;
  if (got < needed)
  {
    FailToRead(path, "a NIfTI header of " + std::to_string(needed) + " bytes", std::to_string(got));
  }
  // The header begins with its own size, which shows the byte order.
  std::int32_t size;
  std::memcpy(&size, bytes, sizeof(size));
  const FieldReader fields{ size != std::int32_t(needed) };
  NiftiHeader header = is1 ? HeaderFromBytes<nifti_1_header>(bytes, fields)
                           : HeaderFromBytes<nifti_2_header>(bytes, fields);
#ifdef VTK_WORDS_BIGENDIAN
  header.bigEndian = !fields.swaps;
#else
  header.bigEndian = fields.swaps;
#endif
  return header;
}

struct NiftiType
{
  int code;
  int scalarType;
  int componentCount;
};

NiftiType TypeOfCode(const std::string& path, int code)
{
  static const NiftiType types[] = {
    { NIFTI_TYPE_UINT8, VTK_UNSIGNED_CHAR, 1 },
    { NIFTI_TYPE_INT16, VTK_SHORT, 1 },
    { NIFTI_TYPE_INT32, VTK_INT, 1 },
    { NIFTI_TYPE_FLOAT32, VTK_FLOAT, 1 },
    { NIFTI_TYPE_FLOAT64, VTK_DOUBLE, 1 },
    { NIFTI_TYPE_RGB24, VTK_UNSIGNED_CHAR, 3 },
    { NIFTI_TYPE_INT8, VTK_SIGNED_CHAR, 1 },
    { NIFTI_TYPE_UINT16, VTK_UNSIGNED_SHORT, 1 },
    { NIFTI_TYPE_UINT32, VTK_UNSIGNED_INT, 1 },
    { NIFTI_TYPE_INT64, VTK_TYPE_INT64, 1 },
    { NIFTI_TYPE_UINT64, VTK_TYPE_UINT64, 1 },
    { NIFTI_TYPE_RGBA32, VTK_UNSIGNED_CHAR, 4 },
  };
  const auto type = std::find_if(
    std::begin(types), std::end(types), [&](const NiftiType& row) { return row.code == code; });
  if (type == std::end(types))
  {
    FailToRead(path, "real numbers of 8 to 64 bits, RGB or RGBA",
      "the NIfTI data type " + std::to_string(code));
  }
  return *type;
}

VoxelLayout LayoutOf(const std::string& path, const NiftiHeader& header, Volume& volume)
{
  const std::int64_t rank = header.dim[0];
  if (rank < 1 || rank > 7)
  {
    FailToRead(path, "1 to 7 dimensions", std::to_string(rank));
  }
  std::int64_t dim[8] = { rank, 1, 1, 1, 1, 1, 1, 1 };
  std::copy_n(header.dim + 1, rank, dim + 1);
  if (dim[4] > 1)
  {
    volume.warnings.push_back(OnlyFirstVolume(dim[4]));
  }
  if (dim[6] > 1 || dim[7] > 1)
  {
    FailToRead(path, "at most 5 dimensions", std::to_string(rank));
  }
  const NiftiType type = TypeOfCode(path, header.datatype);
  // Values along the fifth axis come after all of the fourth, so time points would separate them.
  if (dim[5] > 1 && (type.componentCount > 1 || dim[4] > 1))
  {
    FailToRead(path, "one vector per voxel", "vectors of colours or over time");
  }
  return { { dim[1], dim[2], dim[3] }, type.scalarType, type.componentCount * dim[5] };
}

double MmPerUnit(int units)
{
  constexpr int metre = 1;
  constexpr int micrometre = 3;
  const int lengthUnit = units & 7;
  return lengthUnit == metre ? 1000.0 : lengthUnit == micrometre ? 0.001 : 1.0;
}

/// Geometry in RAS from the affine form, the header's "method 3".
ImageGeometry AffineGeometry(const NiftiHeader& header)
{
  ImageGeometry geometry;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.axesMm[axis][row] = header.affine[row][axis];
    }
    geometry.originMm[row] = header.affine[row][3];
  }
  return geometry;
}

/// Geometry in RAS from the quaternion form, the header's "method 2".
ImageGeometry QuaternionGeometry(const NiftiHeader& header)
{
  const double b = header.quaternion[0];
  const double c = header.quaternion[1];
  const double d = header.quaternion[2];
  const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
  ImageGeometry geometry;
  geometry.axesMm = glm::mat3_cast(glm::normalize(glm::dquat(a, b, c, d)));
  geometry.axesMm[0] *= header.pixdim[1];
  geometry.axesMm[1] *= header.pixdim[2];
  geometry.axesMm[2] *= header.pixdim[0] < 0 ? -header.pixdim[3] : header.pixdim[3];
  geometry.originMm = { header.quaternionOffset[0], header.quaternionOffset[1],
    header.quaternionOffset[2] };
  return geometry;
}

ImageGeometry GeometryOf(const NiftiHeader& header, Volume& volume)
{
  const glm::dvec3 lpsFromRas(-1.0, -1.0, 1.0);
  if (header.affineCode > 0)
  {
    return InLps(AffineGeometry(header), lpsFromRas, MmPerUnit(header.units));
  }
  if (header.quaternionCode > 0)
  {
    return InLps(QuaternionGeometry(header), lpsFromRas, MmPerUnit(header.units));
  }
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis][axis] = header.pixdim[axis + 1];
  }
  volume.warnings.push_back(UnknownSides);
  return InLps(geometry, glm::dvec3(1.0), MmPerUnit(header.units));
}

/// The partner of image.hdr is image.img and vice versa, with or without .gz, whichever exists.
std::string Partner(const std::string& path, const std::string& extension)
{
  std::filesystem::path partner = path;
  if (partner.extension() == ".gz")
  {
    partner.replace_extension();
  }
  partner.replace_extension(extension);
  const std::string compressed = partner.string() + ".gz";
  return std::filesystem::exists(compressed) ? compressed : partner.string();
}

bool IsVoxelFile(const std::string& path)
{
  const std::filesystem::path name = path;
  return name.extension() == ".img" ||
    (name.extension() == ".gz" && name.stem().extension() == ".img");
}

VoxelFile VoxelFileOf(const std::string& headerPath, const NiftiHeader& header)
{
  VoxelFile file;
  file.paths = { header.isOneFile ? headerPath : Partner(headerPath, ".img") };
  ReadableFileSize(file.paths.front());
  file.compression = CompressionOf(file.paths.front());
  file.bigEndian = header.bigEndian;
  file.planar = header.dim[0] >= 5 && header.dim[5] > 1;
  // The upper bound keeps the number an integer that a double represents exactly.
  if (!(header.voxelOffset >= 0 && header.voxelOffset < 9e15))
  {
    FailToRead(headerPath, "voxels at an offset of at least 0",
      "the offset " + std::to_string(header.voxelOffset));
  }
  file.dataOffset = std::int64_t(header.voxelOffset);
  return file;
}

}

Volume ReadNifti(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  Volume volume;
  const std::string headerPath = IsVoxelFile(path) ? Partner(path, ".hdr") : path;
  const NiftiHeader header = ReadHeader(headerPath);
  const VoxelLayout layout = LayoutOf(headerPath, header, volume);
  const ImageGeometry geometry = GeometryOf(header, volume);
  volume.image = ReadVoxels(VoxelFileOf(headerPath, header), layout, progress);

  // A slope of 0 means no rescaling; colours have none either.
  const bool hasRescale = std::isfinite(header.rescale.slope) && header.rescale.slope != 0 &&
    std::isfinite(header.rescale.intercept) &&
    TypeOfCode(path, header.datatype).componentCount == 1;
  volume.image = Rescaled(path, volume.image, { hasRescale ? header.rescale : Rescale() });
  PlaceImage(headerPath, geometry, volume.image);

  const double window = header.calibration[1] - header.calibration[0];
  if (std::isfinite(window) && window > 0)
  {
    volume.windowLevel = { window, header.calibration[0] + window / 2 };
  }
  return volume;
}

}
