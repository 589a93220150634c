// MetaImage: a text header with the voxels in the same file (.mha) or in others (.mhd). See
// https://itk.org/Wiki/MetaIO/Documentation
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <array>
#include <map>

namespace varimarch
{
namespace
{

struct MetaHeader
{
  std::string path;
  HeaderFields fields;
  std::vector<std::string> listedFiles; ///< the lines after ElementDataFile = LIST
  std::uint64_t end = 0;                ///< offset of the voxels in a file that also has the header
  std::int64_t rank = 0;
};

const std::vector<std::string> directionKeys = { "transformmatrix", "rotation", "orientation" };
const char* const dataFileKey = "elementdatafile";

MetaHeader ReadMetaHeader(const std::string& path)
{
  MetaHeader header;
  header.path = path;
  HeaderLines lines(path);
  // The field for the data file is the last; voxels or the lines of a list follow it.
  while (!header.fields.Has(dataFileKey))
  {
    const std::optional<std::string> line = lines.Next();
    const std::size_t separator = line ? line->find_first_of("=:") : std::string::npos;
    if (!line || (separator == std::string::npos && !Trimmed(*line).empty()))
    {
      FailToRead(path, "a MetaImage header of lines \"Key = Value\" up to ElementDataFile",
        line ? Quoted(*line) : "the end of the file");
    }
    if (separator != std::string::npos)
    {
      header.fields.Set(
        LowerCase(Trimmed(line->substr(0, separator))), Trimmed(line->substr(separator + 1)));
    }
  }
  header.end = lines.Position();
  const bool isList = IsFileList(header.fields.Value({ dataFileKey }));
  for (auto line = lines.Next(); isList && line; line = lines.Next())
  {
    if (!Trimmed(*line).empty())
    {
      header.listedFiles.push_back(Trimmed(*line));
    }
  }
  header.rank = IntegerFromText(path, "2, 3 or 4 as NDims", header.fields.Value({ "ndims" }));
  if (header.rank < 2 || header.rank > 4)
  {
    FailToRead(path, "2, 3 or 4 as NDims", std::to_string(header.rank));
  }
  return header;
}

bool IsTrue(const MetaHeader& header, const std::vector<std::string>& keys)
{
  const std::string value = header.fields.Value(keys);
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

/// Type sizes are those of MetaIO, whose long has 4 bytes.
int TypeOf(const MetaHeader& header)
{
  static const std::map<std::string, int> types = {
    { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR },
    { "MET_SHORT", VTK_SHORT },
    { "MET_USHORT", VTK_UNSIGNED_SHORT },
    { "MET_INT", VTK_INT },
    { "MET_UINT", VTK_UNSIGNED_INT },
    { "MET_LONG", VTK_INT },
    { "MET_ULONG", VTK_UNSIGNED_INT },
    { "MET_LONG_LONG", VTK_TYPE_INT64 },
    { "MET_ULONG_LONG", VTK_TYPE_UINT64 },
    { "MET_FLOAT", VTK_FLOAT },
    { "MET_DOUBLE", VTK_DOUBLE },
  };
  const std::string stated = header.fields.Value({ "elementtype" });
  const auto type = types.find(stated.substr(0, stated.find("_ARRAY")));
  if (type == types.end())
  {
    FailToRead(header.path, "an ElementType such as MET_SHORT", Quoted(stated));
  }
  return type->second;
}

/// Number of voxels along each axis; 1 for missing axes.
std::array<std::int64_t, 4> SizesOf(const MetaHeader& header)
{
  const std::vector<std::string> words = Words(header.fields.Value({ "dimsize" }));
  if (words.size() != std::size_t(header.rank))
  {
    FailToRead(header.path, std::to_string(header.rank) + " numbers as DimSize",
      std::to_string(words.size()));
  }
  std::array<std::int64_t, 4> sizes = { 1, 1, 1, 1 };
  std::transform(words.begin(), words.end(), sizes.begin(),
    [&](const std::string& word)
    { return IntegerFromText(header.path, "whole numbers as DimSize", word); });
  if (sizes[3] < 1)
  {
    FailToRead(header.path, "at least one volume", std::to_string(sizes[3]));
  }
  return sizes;
}

VoxelLayout LayoutOf(const MetaHeader& header)
{
  const auto sizes = SizesOf(header);
  const std::string channels = header.fields.Value({ "elementnumberofchannels" });
  return { { sizes[0], sizes[1], sizes[2] }, TypeOf(header),
    channels.empty()
      ? 1
      : IntegerFromText(header.path, "a number as ElementNumberOfChannels", channels) };
}

/// The numbers of a field with one per axis, or `otherwise` for each axis if the field is missing.
std::vector<double> NumbersPerAxis(
  const MetaHeader& header, const std::vector<std::string>& keys, double otherwise)
{
  const std::string value = header.fields.Value(keys);
  std::vector<double> numbers(3, otherwise);
  if (!value.empty())
  {
    // Like MetaIO, this ignores numbers beyond the dimensions.
    const std::size_t count = std::max(std::size_t(header.rank), Words(value).size());
    numbers = NumbersFromText(header.path, keys.front(), value, count);
    numbers.resize(std::size_t(header.rank), otherwise);
    numbers.resize(3, otherwise);
  }
  return numbers;
}

ImageGeometry GeometryOf(const MetaHeader& header, std::vector<std::string>& warnings)
{
  const std::vector<double> spacing =
    NumbersPerAxis(header, { "elementspacing", "elementsize" }, 1.0);
  const std::vector<double> origin =
    NumbersPerAxis(header, { "offset", "position", "origin" }, 0.0);
  glm::dmat3 direction(1.0);
  const std::string matrix = header.fields.Value(directionKeys);
  if (!matrix.empty())
  {
    const auto rank = std::size_t(header.rank);
    const auto numbers = NumbersFromText(header.path, "transformmatrix", matrix, rank * rank);
    // The first `rank` numbers are the direction of the first axis, and so on.
    for (std::size_t i = 0; i < std::min<std::size_t>(rank, 3) * rank; ++i)
    {
      if (i % rank < 3)
      {
        direction[int(i / rank)][int(i % rank)] = numbers[i];
      }
    }
  }
  const double mmPerUnit = MmPerUnitOrWarn(header.fields.Value({ "distanceunits" }), warnings);
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = direction[axis] * spacing[axis] * mmPerUnit;
    geometry.originMm[axis] = origin[axis] * mmPerUnit;
  }
  return geometry;
}

/// True if the file states a linear function of the values. MetaIO leaves it to its callers, and
/// ITK and VTK do not apply it.
bool HasIntensityFunction(const MetaHeader& header)
{
  const auto differs = [&](const std::string& key, double usual)
  {
    const std::string value = header.fields.Value({ key });
    return !value.empty() && NumberFromText(header.path, key, value) != usual;
  };
  return differs("elementtointensityfunctionslope", 1.0) ||
    differs("elementtointensityfunctionoffset", 0.0);
}

VoxelFile VoxelFileOf(const MetaHeader& header)
{
  VoxelFile file;
  file.volumeCount = SizesOf(header)[3];
  const std::string name = header.fields.Value({ dataFileKey });
  if (LowerCase(name) == "local")
  {
    file.paths = { header.path };
    file.fileOffset = std::int64_t(header.end);
  }
  else
  {
    file.paths = DataFiles(header.path, name, header.listedFiles);
    const std::string skip = header.fields.Value({ "headersize" });
    file.dataOffset =
      skip.empty() ? 0 : IntegerFromText(header.path, "a number as HeaderSize", skip);
    if (file.dataOffset < VoxelFile::FromEnd)
    {
      FailToRead(header.path, "at least -1 as HeaderSize", skip);
    }
  }
  const bool isBinary = !header.fields.Has("binarydata") || IsTrue(header, { "binarydata" });
  file.encoding = isBinary ? VoxelEncoding::Binary : VoxelEncoding::Text;
  file.compression =
    IsTrue(header, { "compresseddata" }) ? Compression::Deflate : Compression::None;
  file.bigEndian = IsTrue(header, { "elementbyteordermsb", "binarydatabyteordermsb" });
  return file;
}

}

Volume ReadMetaImage(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const MetaHeader header = ReadMetaHeader(path);
  Volume volume;
  const ImageGeometry geometry = GeometryOf(header, volume.warnings);
  VoxelFile file = VoxelFileOf(header);
  // The header has a distance of the volumes, but not its unit.
  TakeTimes(path, NumberedTimes(file.volumeCount), options, volume);
  file.volume = options.time;
  file.kept = StreamOf(options);
  file.mapping = MappingOf(options);
  volume.image = ReadVoxels(file, LayoutOf(header), progress);
  PlaceImage(path, geometry, volume.image);
  if (header.fields.Value(directionKeys).empty())
  {
    volume.warnings.push_back(UnknownSides);
  }
  if (HasIntensityFunction(header))
  {
    volume.warnings.push_back("The file states a conversion of its values to intensities "
                              "(ElementToIntensityFunction), which was not applied.");
  }
  const std::string modality = header.fields.Value({ "modality" });
  volume.modality = modality == "MET_MOD_CT" ? "CT" : modality == "MET_MOD_MR" ? "MR" : "";
  return volume;
}

}
