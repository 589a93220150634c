// NIfTI-1, NIfTI-2 and Analyze 7.5: one file (.nii), or a header (.hdr) with the voxels in a second
// file (.img), optionally compressed. See https://nifti.nimh.nih.gov/nifti-1 and /nifti-2.
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/KeptInput.h"
#include "Readers/Magnitude.h"
#include "Readers/NiftiGeometry.h"
#include "Readers/NiftiHeader.h"
#include "Readers/NiftiLayout.h"
#include "Readers/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace varimarch
{
namespace
{

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
