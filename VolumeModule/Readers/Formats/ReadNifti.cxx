// NIfTI-1, NIfTI-2 and Analyze 7.5: one file (.nii), or a header (.hdr) with the voxels in a second
// file (.img), optionally compressed. See https://nifti.nimh.nih.gov/nifti-1 and /nifti-2.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Formats/NiftiHeader.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelFile.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// The head of a variable in a MATLAB file of version 4 (MAT-File Format, "Level 4").
struct VariableHead
{
  std::int32_t type; ///< 0: little-endian doubles, column by column
  std::int32_t rows;
  std::int32_t columns;
  std::int32_t isComplex;
  std::int32_t nameBytes; ///< with the final zero
};

struct Variable
{
  std::string name;
  std::array<double, 16> numbers; ///< a matrix of 4 x 4, column by column
};

/// The next variable, which must be a real matrix of 4 x 4; nothing for any other.
std::optional<Variable> NextVariable(ByteStream& stream)
{
  VariableHead head = {};
  const bool isMatrix = stream.Read(&head, sizeof(head)) == sizeof(head) && head.type == 0 &&
    head.rows == 4 && head.columns == 4 && head.isComplex == 0 && head.nameBytes > 0 &&
    head.nameBytes < 64;
  if (!isMatrix)
  {
    return std::nullopt;
  }
  Variable variable;
  variable.name.resize(std::size_t(head.nameBytes));
  stream.Read(variable.name.data(), variable.name.size());
  variable.name.pop_back();
  const std::size_t byteCount = sizeof(variable.numbers);
  return stream.Read(variable.numbers.data(), byteCount) == byteCount ? std::optional(variable)
                                                                      : std::nullopt;
}

ImageGeometry GeometryOf(const Variable& variable)
{
  const auto at = [&](int row, int column)
  { return variable.numbers[std::size_t(4 * column + row)]; };
  // "mat" has all in it, "M" leaves out that the first axis points to the patient's left.
  const glm::dvec3 signs(variable.name == "M" ? -1.0 : 1.0, 1.0, 1.0);
  ImageGeometry geometry;
  for (int row = 0; row < 3; ++row)
  {
    geometry.originMm[row] = at(row, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.axesMm[axis][row] = at(row, axis);
      geometry.originMm[row] += at(row, axis);
    }
  }
  return InLps(geometry, signs, 1.0);
}

/// The geometry in RAS [mm] of an Analyze header, from the file .mat that SPM99 and SPM2 write
/// beside it: a MATLAB file of version 4 with a matrix "mat" or "M" that maps voxels, counted from
/// 1, to mm. Nothing if there is no such file.
/// @param warnings  receives a sentence about a file that has no such matrix
std::optional<ImageGeometry> SpmMatrixBeside(
  const std::string& headerPath, std::vector<std::string>& warnings)
{
  const std::filesystem::path path = std::filesystem::path(headerPath).replace_extension(".mat");
  if (!std::filesystem::is_regular_file(path))
  {
    return std::nullopt;
  }
  const auto stream = OpenStream(path.string(), Compression::None);
  std::optional<ImageGeometry> geometry;
  for (auto variable = NextVariable(*stream); variable; variable = NextVariable(*stream))
  {
    const bool isBest = variable->name == "mat";
    if (isBest || (variable->name == "M" && !geometry))
    {
      geometry = GeometryOf(*variable);
    }
    if (isBest)
    {
      break;
    }
  }
  if (!geometry)
  {
    warnings.push_back("The file " + path.filename().string() +
      " beside the header has no matrix in the way of SPM99, and was not used.");
  }
  return geometry;
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

/// Size of a voxel along an axis. The standard wants it positive; like nibabel, this takes 0 for 1.
double VoxelSize(const NiftiHeader& header, int axis)
{
  const double size = std::abs(header.pixdim[axis + 1]);
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
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
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] *= VoxelSize(header, axis);
  }
  geometry.axesMm[2] *= header.pixdim[0] < 0 ? -1.0 : 1.0;
  geometry.originMm = { header.quaternionOffset[0], header.quaternionOffset[1],
    header.quaternionOffset[2] };
  return geometry;
}

/// True if the numbers are finite and the axes span space.
bool IsValid(const ImageGeometry& geometry)
{
  const double volume = std::abs(glm::determinant(geometry.axesMm));
  const glm::dvec3 origin = geometry.originMm;
  return std::isnormal(volume) && std::isfinite(origin.x + origin.y + origin.z);
}

/// Replaces the step of an axis with a single voxel, which has no neighbours, if it is 0.
ImageGeometry WithAllAxes(const NiftiHeader& header, ImageGeometry geometry)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3& step = geometry.axesMm[axis];
    const bool isSingle = header.dim[0] <= axis || header.dim[axis + 1] == 1;
    if (isSingle && step == glm::dvec3(0.0))
    {
      const glm::dvec3 normal =
        glm::cross(geometry.axesMm[(axis + 1) % 3], geometry.axesMm[(axis + 2) % 3]);
      step = normal == glm::dvec3(0.0) ? normal : glm::normalize(normal) * VoxelSize(header, axis);
    }
  }
  return geometry;
}

/// The side that each axis faces most: 1, 2 or 3 for x, y or z, negative for the opposite.
std::array<int, 3> Sides(const ImageGeometry& geometry)
{
  std::array<int, 3> sides = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 size = glm::abs(geometry.axesMm[axis]);
    const int most = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    sides[std::size_t(axis)] = geometry.axesMm[axis][most] < 0.0 ? -most - 1 : most + 1;
  }
  return sides;
}

/// Geometry in RAS from the header's forms; nothing if it has no valid one.
std::optional<ImageGeometry> GeometryOfForms(
  const NiftiHeader& header, std::vector<std::string>& warnings)
{
  const ImageGeometry affine = WithAllAxes(header, AffineGeometry(header));
  const ImageGeometry quaternion = QuaternionGeometry(header);
  const bool hasAffine = header.affineCode > 0 && IsValid(affine);
  const bool hasQuaternion = header.quaternionCode > 0 && IsValid(quaternion);
  if (header.affineCode > 0 && !hasAffine)
  {
    warnings.push_back(std::string("The header's sform is not a valid matrix; ") +
      (hasQuaternion ? "the qform was used." : "only the size of a voxel was used."));
  }
  if (hasAffine && hasQuaternion && Sides(affine) != Sides(quaternion))
  {
    warnings.push_back("The header's sform and qform turn the volume to different sides. The sform "
                       "was used; other programs may show the volume mirrored.");
  }
  return hasAffine  ? std::optional(affine)
    : hasQuaternion ? std::optional(quaternion)
                    : std::nullopt;
}

/// Geometry in RAS from SPM's origin, which counts voxels from 1. In Analyze files of SPM the first
/// axis points to the patient's left.
std::optional<ImageGeometry> GeometryOfSpmOrigin(const NiftiHeader& header)
{
  const double* const origin = header.spmOrigin;
  bool isStated = origin[0] != 0.0 || origin[1] != 0.0 || origin[2] != 0.0;
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Like nibabel, this takes an origin far outside for other data.
    const double voxelCount = double(header.dim[axis + 1]);
    isStated = isStated && origin[axis] > -voxelCount && origin[axis] < 2.0 * voxelCount;
    geometry.axesMm[axis][axis] = VoxelSize(header, axis) * (axis == 0 ? -1.0 : 1.0);
    geometry.originMm[axis] = -geometry.axesMm[axis][axis] * (origin[axis] - 1.0);
  }
  return isStated ? std::optional(geometry) : std::nullopt;
}

/// The geometry in LPS [mm]: the header's affine form (sform), or else its quaternion form (qform),
/// or else only the size of a voxel. For Analyze it is that of SPM, if the header or a file .mat
/// states one.
/// @param path  path of the header
/// @param warnings  receives sentences about forms that are invalid or contradict each other
ImageGeometry GeometryOf(
  const std::string& path, const NiftiHeader& header, std::vector<std::string>& warnings)
{
  std::optional<ImageGeometry> geometry = header.kind == NiftiKind::Analyze
    ? SpmMatrixBeside(path, warnings)
    : GeometryOfForms(header, warnings);
  if (!geometry && header.kind == NiftiKind::Analyze)
  {
    geometry = GeometryOfSpmOrigin(header);
  }
  const int usedAxes = int(std::min<std::int64_t>(3, header.dim[0]));
  if (std::any_of(header.pixdim + 1, header.pixdim + 1 + usedAxes,
        [](double size) { return !(std::abs(size) > 0.0); }))
  {
    warnings.push_back("The header does not say how large a voxel is along each axis; 1 mm was "
                       "assumed where it is missing.");
  }
  if (geometry)
  {
    return InLps(*geometry, LpsFromRas, MmPerUnit(header.units));
  }
  ImageGeometry sizes;
  for (int axis = 0; axis < 3; ++axis)
  {
    sizes.axesMm[axis][axis] = VoxelSize(header, axis);
  }
  warnings.push_back(UnknownSides);
  return InLps(sizes, glm::dvec3(1.0), MmPerUnit(header.units));
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
    { NIFTI_TYPE_COMPLEX64, VTK_FLOAT, 2 },
    { NIFTI_TYPE_COMPLEX128, VTK_DOUBLE, 2 },
  };
  const auto type = std::find_if(
    std::begin(types), std::end(types), [&](const NiftiType& row) { return row.code == code; });
  if (type == std::end(types))
  {
    const bool isLong = code == NIFTI_TYPE_FLOAT128 || code == NIFTI_TYPE_COMPLEX256;
    FailToRead(path, "numbers of 8 to 64 bits, RGB or RGBA",
      isLong ? "numbers of 128 bits" : "the NIfTI data type " + std::to_string(code));
  }
  return *type;
}

/// Number of values along the fifth axis, which holds components if it is short or if the file says
/// so, and several volumes otherwise. Values along it come after all of the fourth axis, so time
/// points would separate them.
std::int64_t VectorLength(
  const NiftiHeader& header, const std::array<std::int64_t, 8>& dim, const NiftiType& type)
{
  static const std::set<int> vectorIntents = { 1004, 1005, 1006, 1007, 1008, 1009, 1010, 2003,
    2004 };
  const bool isVector = dim[5] <= 4 || vectorIntents.count(header.intent) > 0;
  const bool isAlone = dim[4] == 1 && dim[6] == 1 && dim[7] == 1 && type.componentCount == 1;
  return isVector && isAlone ? dim[5] : 1;
}

/// The volumes: those of the fourth axis are times if the header has their distance.
VolumeTimes TimesOf(const NiftiHeader& header, std::int64_t alongFourth, double volumeCount)
{
  // The bits of the units of time in xyzt_units.
  constexpr int UnitOfTime = 0x38;
  static const std::map<int, double> secondsOfUnits = { { 8, 1.0 }, { 16, 1e-3 }, { 24, 1e-6 } };
  const auto unit = secondsOfUnits.find(header.units & UnitOfTime);
  const double seconds = unit == secondsOfUnits.end() ? 0.0 : unit->second;
  return double(alongFourth) == volumeCount
    ? EvenTimes(alongFourth, header.timeOffset * seconds, header.pixdim[4] * seconds)
    : NumberedTimes(WholeNumber(volumeCount));
}

VoxelLayout LayoutOf(
  const std::string& path, const NiftiHeader& header, const ReadOptions& options, Volume& volume)
{
  if (header.intent >= 3000 && header.intent < 3100)
  {
    FailToRead(path, "a volume", "a CIFTI matrix, which belongs to surfaces");
  }
  const std::int64_t rank = header.dim[0];
  if (rank < 1 || rank > 7)
  {
    FailToRead(path, "1 to 7 dimensions", std::to_string(rank));
  }
  // A size of 0 counts as 1, except along the axes of the volume.
  std::array<std::int64_t, 8> dim = { rank, 1, 1, 1, 1, 1, 1, 1 };
  for (std::int64_t axis = 1; axis <= rank; ++axis)
  {
    dim[axis] = axis > 3 ? std::max<std::int64_t>(1, header.dim[axis]) : header.dim[axis];
  }
  const NiftiType type = TypeOfCode(path, header.datatype);
  const std::int64_t componentCount = type.componentCount * VectorLength(header, dim, type);
  const double volumeCount = double(dim[4]) * double(dim[5]) * double(dim[6]) * double(dim[7]) *
    type.componentCount / double(componentCount);
  TakeTimes(path, TimesOf(header, dim[4], volumeCount), options, volume);
  return { { dim[1], dim[2], dim[3] }, type.scalarType, componentCount };
}

/// The partner of image.hdr is image.img and vice versa, with or without .gz, whichever exists.
std::string NiftiPartner(const std::string& path, const std::string& extension)
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

/// The file with the header: this file, or its partner if this one has only voxels.
std::string HeaderPath(const std::string& path)
{
  std::filesystem::path name = path;
  if (name.extension() == ".gz")
  {
    name.replace_extension();
  }
  return name.extension() == ".img" && !IsNifti(FirstBytes(path)) ? NiftiPartner(path, ".hdr")
                                                                  : path;
}

/// The header in a file. One with the mark of a pair is a file of its own if it is named so and has
/// no partner.
NiftiHeader HeaderIn(const std::string& path)
{
  NiftiHeader header = ReadNiftiHeader(path);
  std::filesystem::path name = path;
  if (name.extension() == ".gz")
  {
    name.replace_extension();
  }
  const bool isAlone = header.kind == NiftiKind::Pair && name.extension() == ".nii" &&
    !std::filesystem::exists(NiftiPartner(path, ".img"));
  header.kind = isAlone ? NiftiKind::OneFile : header.kind;
  return header;
}

/// File offset of the voxels, after decompression.
std::int64_t VoxelOffset(const std::string& path, const NiftiHeader& header, Volume& volume)
{
  // The upper bound keeps the number an integer that a double represents exactly.
  if (!(header.voxelOffset >= 0 && header.voxelOffset < 9e15))
  {
    FailToRead(path, "voxels at an offset of at least 0",
      "the offset " + std::to_string(header.voxelOffset));
  }
  const auto stated = std::int64_t(header.voxelOffset);
  const auto least = std::int64_t(header.byteCount);
  if (header.kind != NiftiKind::OneFile || stated >= least)
  {
    return stated;
  }
  volume.warnings.push_back("The header says that the voxels begin inside it, at byte " +
    std::to_string(stated) + "; they were read from byte " + std::to_string(least) + ".");
  return least;
}

VoxelFile VoxelFileOf(const std::string& headerPath, const NiftiHeader& header,
  const ReadOptions& options, Volume& volume)
{
  VoxelFile file;
  file.paths = { header.kind == NiftiKind::OneFile ? headerPath
                                                   : NiftiPartner(headerPath, ".img") };
  ReadableFileSize(file.paths.front());
  file.compression = CompressionOf(file.paths.front());
  file.bigEndian = header.bigEndian;
  file.planar = header.dim[0] >= 5 && header.dim[5] > 1;
  file.dataOffset =
    VoxelOffset(headerPath, header, volume) * (header.padsEachVolume ? options.time + 1 : 1);
  file.volume = options.time;
  file.kept = StreamOf(options);
  return file;
}

bool IsRescaled(const Rescale& rescale)
{
  const bool isStated =
    std::isfinite(rescale.slope) && rescale.slope != 0 && std::isfinite(rescale.intercept);
  return isStated && !(rescale.slope == 1 && rescale.intercept == 0);
}

/// Applies the slope and intercept, unless the slope is 0, which means none. Colours have none
/// either, and the intercept of complex numbers has no effect on their magnitude.
void ApplyRescale(const std::string& path, const NiftiHeader& header, Volume& volume)
{
  const bool isComplex =
    header.datatype == NIFTI_TYPE_COMPLEX64 || header.datatype == NIFTI_TYPE_COMPLEX128;
  Rescale rescale = header.rescale;
  if (isComplex)
  {
    TakeMagnitude("The numbers are complex", volume);
    rescale = { std::abs(rescale.slope), 0.0 };
  }
  const bool isColour = !isComplex && TypeOfCode(path, header.datatype).componentCount > 1;
  volume.holdsColors = isColour;
  volume.image =
    Rescaled(path, volume.image, { IsRescaled(rescale) && !isColour ? rescale : Rescale() });
}

}

Volume ReadNifti(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  Volume volume;
  const std::string headerPath = HeaderPath(path);
  const NiftiHeader header = HeaderIn(headerPath);
  const VoxelLayout layout = LayoutOf(headerPath, header, options, volume);
  const ImageGeometry geometry = GeometryOf(headerPath, header, volume.warnings);
  VoxelFile file = VoxelFileOf(headerPath, header, options, volume);
  file.conversion = IsRescaled(header.rescale) ? "rescaled" : "";
  file.mapping = MappingOf(options);
  volume.image = ReadVoxels(file, layout, progress);
  ApplyRescale(headerPath, header, volume);
  PlaceImage(headerPath, geometry, volume.image);

  constexpr int LabelIntent = 1002; // NIFTI_INTENT_LABEL, which VTK's header lacks
  if (header.intent == LabelIntent)
  {
    volume.segments.emplace(); // the header has no names
  }
  const double window = header.calibration[1] - header.calibration[0];
  if (std::isfinite(window) && window > 0)
  {
    volume.windowLevel = { window, header.calibration[0] + window / 2 };
  }
  return volume;
}

}
