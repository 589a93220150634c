// Philips PAR/REC: a text header (.PAR) with one line per image, and the images in a second file
// (.REC) of little-endian, unsigned numbers. The header describes itself in its comments; the order
// of its rotations was found by the authors of nibabel, see parrec.py there.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

namespace varimarch
{
namespace
{

constexpr const char* parMark = "# === DATA DESCRIPTION FILE";

/// An image of the list, which is one slice of one volume.
struct ParImage
{
  int slice;          ///< number of the slice, from 1
  std::int64_t index; ///< number of the image in the voxel file, from 0
  int bits;
  std::array<std::int64_t, 2> size;
  Rescale rescale;
  double thicknessMm;
  double gapMm;
  int orientation; ///< 1 transverse, 2 sagittal, 3 coronal
  std::array<double, 2> spacingMm;
  double beginSeconds; ///< begin of the dynamic scan, since that of the first; 0 if not stated
};

struct ParHeader
{
  std::string path;
  HeaderFields fields;
  std::vector<ParImage> images;
};

/// Parses a line of the list; the columns are those of the versions 4 to 4.2.
ParImage ImageOf(const std::string& path, const std::string& line)
{
  constexpr std::size_t MostColumns = 32;
  std::vector<double> columns;
  for (const std::string& word : Words(line))
  {
    if (columns.size() == MostColumns)
    {
      break;
    }
    columns.push_back(NumberFromText(path, "a list of images with numbers", word));
  }
  if (columns.size() < 30)
  {
    FailToRead(path, "at least 30 numbers for each image", Quoted(line));
  }
  const auto whole = [&](std::size_t column)
  { return WholeNumber(std::clamp(columns[column], -2e9, 2e9)); };
  return { int(whole(0)), whole(6), int(whole(7)), { whole(9), whole(10) },
    { columns[12], columns[11] }, columns[22], columns[23], int(whole(25)),
    { columns[28], columns[29] }, columns.size() == MostColumns ? columns.back() : 0.0 };
}

ParHeader ReadParHeader(const std::string& path)
{
  ParHeader header;
  header.path = path;
  HeaderLines lines(path);
  std::string version = "none";
  while (const std::optional<std::string> line = lines.Next())
  {
    const std::string text = Trimmed(*line);
    const std::size_t colon = text.find(':');
    if (text.find("image export tool") != std::string::npos)
    {
      version = Words(text).back();
    }
    else if (!text.empty() && text.front() == '.' && colon != std::string::npos)
    {
      header.fields.Set(Trimmed(text.substr(1, colon - 1)), Trimmed(text.substr(colon + 1)));
    }
    else if (!text.empty() && text.front() != '#')
    {
      header.images.push_back(ImageOf(path, text));
    }
  }
  if (version.compare(0, 2, "V4") != 0 || header.images.empty())
  {
    FailToRead(path, "a list of images of version 4, 4.1 or 4.2",
      "the version " + Quoted(version) + " and " + std::to_string(header.images.size()) +
        " images");
  }
  return header;
}

/// The images of each slice, by its number, in the order of the list: one of each for each volume.
std::map<int, std::vector<ParImage>> SlicesOf(const ParHeader& header)
{
  std::map<int, std::vector<ParImage>> slices;
  for (const ParImage& image : header.images)
  {
    slices[image.slice].push_back(image);
  }
  return slices;
}

/// The times of the volumes. One that the scan did not complete is left out, with a warning.
VolumeTimes TimesOf(const ParHeader& header, std::vector<std::string>& warnings)
{
  const auto slices = SlicesOf(header);
  std::size_t count = header.images.size();
  for (const auto& [number, images] : slices)
  {
    count = std::min(count, images.size());
  }
  const std::size_t left = header.images.size() - count * slices.size();
  if (left > 0)
  {
    warnings.push_back(
      std::to_string(left) + " images of volumes that are not complete were left out.");
  }
  std::vector<double> seconds;
  for (std::size_t i = 0; i < count; ++i)
  {
    seconds.push_back(slices.begin()->second[i].beginSeconds);
  }
  return StatedTimes(seconds);
}

/// The images of a volume, in order of their slices.
std::vector<ParImage> VolumeAt(const ParHeader& header, std::size_t time)
{
  std::vector<ParImage> images;
  for (const auto& [number, all] : SlicesOf(header))
  {
    const ParImage& image = all[time];
    images.push_back(image);
    const ParImage& first = images.front();
    if (number != int(images.size()))
    {
      FailToRead(header.path, "images of slice " + std::to_string(images.size()),
        "none before slice " + std::to_string(number));
    }
    if (image.size != first.size || image.bits != first.bits || image.index < 0 ||
      image.orientation != first.orientation || image.spacingMm != first.spacingMm)
    {
      FailToRead(header.path, "slices of one size, type and orientation",
        "others for slice " + std::to_string(number));
    }
  }
  const std::string stated = header.fields.Value({ "Max. number of slices/locations" });
  if (!stated.empty() && stated != std::to_string(images.size()))
  {
    FailToRead(header.path, "images of " + stated + " slices", std::to_string(images.size()));
  }
  return images;
}

VoxelLayout LayoutOf(const ParHeader& header, const std::vector<ParImage>& slices)
{
  const ParImage& first = slices.front();
  if (first.bits != 8 && first.bits != 16)
  {
    FailToRead(header.path, "pixels of 8 or 16 bits", std::to_string(first.bits));
  }
  return { { first.size[0], first.size[1], std::int64_t(slices.size()) },
    ScalarTypeOf(NumberKind::Unsigned, first.bits / 8) };
}

/// The axes of a slice orientation in Philips' space (to the back, to the head, to the left).
glm::dmat3 AxesOfOrientation(const ParHeader& header, int orientation)
{
  const glm::dvec3 back(1.0, 0.0, 0.0);
  const glm::dvec3 head(0.0, 1.0, 0.0);
  const glm::dvec3 left(0.0, 0.0, 1.0);
  switch (orientation)
  {
    case 1:
      return { left, back, head };
    case 2:
      return { back, -head, -left };
    case 3:
      return { left, -head, back };
    default:
      FailToRead(header.path, "the slice orientation 1, 2 or 3", std::to_string(orientation));
  }
}

/// Three numbers about the directions back, head and left.
glm::dvec3 Vector(const ParHeader& header, const std::string& key)
{
  const std::vector<double> numbers =
    NumbersFromText(header.path, key, header.fields.Value({ key }), 3);
  return { numbers[0], numbers[1], numbers[2] };
}

ImageGeometry GeometryOf(const ParHeader& header, const VoxelLayout& layout)
{
  const ParImage& image = header.images.front();
  const glm::dvec3 angles = glm::radians(Vector(header, "Angulation midslice(ap,fh,rl)[degr]"));
  const glm::dvec3 centreMm = Vector(header, "Off Centre midslice(ap,fh,rl) [mm]");
  const glm::dmat3 rotation = glm::mat3_cast(glm::angleAxis(angles.z, glm::dvec3(0.0, 0.0, 1.0)) *
    glm::angleAxis(angles.x, glm::dvec3(1.0, 0.0, 0.0)) *
    glm::angleAxis(angles.y, glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 spacingMm(
    image.spacingMm[0], image.spacingMm[1], image.thicknessMm + image.gapMm);
  const glm::dmat3 axesMm = rotation * AxesOfOrientation(header, image.orientation);
  const auto inLps = [](const glm::dvec3& v) { return glm::dvec3(v.z, v.x, v.y); };
  ImageGeometry geometry;
  geometry.originMm = inLps(centreMm);
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = inLps(axesMm[axis] * spacingMm[axis]);
    geometry.originMm -=
      geometry.axesMm[axis] * (0.5 * double(layout.dimensions[std::size_t(axis)] - 1));
  }
  return geometry;
}

/// Reads the slices, which may be anywhere in the file.
vtkSmartPointer<vtkImageData> ReadSlices(const std::string& path, const VoxelLayout& layout,
  const std::vector<ParImage>& slices, ReadProgress& progress)
{
  const std::uint64_t sliceBytes = CheckedByteCount(path, layout) / slices.size();
  const double fileBytes = double(ReadableFileSize(path));
  for (const ParImage& slice : slices)
  {
    const double neededBytes = double(slice.index + 1) * double(sliceBytes);
    if (neededBytes > fileBytes)
    {
      FailToRead(path, ByteText(neededBytes) + " of voxels", ByteText(fileBytes));
    }
  }
  auto image = AllocatedImage(layout);
  auto* destination = static_cast<char*>(image->GetScalarPointer());
  const double count = double(slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    const auto stream =
      OpenStream(path, Compression::None, std::uint64_t(slices[i].index) * sliceBytes);
    ReadProgress part = progress.Part(double(i) / count, (double(i) + 1.0) / count);
    ReadBytes(path, *stream, destination + i * sliceBytes, sliceBytes, part);
  }
  SwapToHostOrder(false, image);
  return image;
}

/// The header or voxel file beside the given one, whose names are both in upper or lower case.
std::string ParPartner(const std::string& path, const std::string& extension)
{
  std::filesystem::path partner = path;
  const std::string own = partner.extension();
  if (LowerCase(own) == extension)
  {
    return path;
  }
  std::string changed = extension;
  if (own != LowerCase(own))
  {
    std::transform(changed.begin(), changed.end(), changed.begin(),
      [](unsigned char character) { return char(std::toupper(character)); });
  }
  return partner.replace_extension(changed).string();
}

}

bool IsPar(const std::string& head)
{
  return head.compare(0, std::string(parMark).size(), parMark) == 0;
}

Volume ReadParRec(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const ParHeader header = ReadParHeader(ParPartner(path, ".par"));
  Volume volume;
  volume.modality = "MR";
  TakeTimes(path, TimesOf(header, volume.warnings), options, volume);
  const std::vector<ParImage> slices = VolumeAt(header, std::size_t(options.time));
  const VoxelLayout layout = LayoutOf(header, slices);
  const ImageGeometry geometry = GeometryOf(header, layout);
  volume.image = ReadSlices(ParPartner(path, ".rec"), layout, slices, progress);
  std::vector<Rescale> rescales;
  for (const ParImage& slice : slices)
  {
    rescales.push_back(slice.rescale);
  }
  volume.image = Rescaled(path, volume.image, rescales);
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
