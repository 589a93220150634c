// AFNI: a text header (.HEAD) with the voxels in a second file (.BRIK, perhaps gzipped). See
// https://afni.nimh.nih.gov/pub/dist/doc/program_help/README.attributes.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace varimarch
{
namespace
{

/// The attributes of a header: texts, or lists of numbers.
class AfniHeader
{
public:
  explicit AfniHeader(const std::string& path);

  const std::string& Path() const { return this->path; }
  bool Has(const std::string& name) const { return this->fields.Has(name); }
  std::string Text(const std::string& name) const { return this->fields.Value({ name }); }

  /// At least `count` numbers.
  std::vector<double> Numbers(const std::string& name, std::size_t count) const;

private:
  struct Attribute
  {
    std::string name;
    std::string count; ///< the stated number of numbers or characters
    std::string value;
  };

  void Keep(const Attribute& attribute);

  std::string path;
  HeaderFields fields;
};

bool BeginsAttribute(const std::string& line)
{
  return line.compare(0, 4, "type") == 0 && line.find("-attribute") != std::string::npos;
}

AfniHeader::AfniHeader(const std::string& path)
  : path(path)
{
  HeaderLines lines(path);
  Attribute attribute;
  while (const std::optional<std::string> line = lines.Next())
  {
    const std::size_t equals = line->find('=');
    const std::string right = equals == std::string::npos ? "" : Trimmed(line->substr(equals + 1));
    if (BeginsAttribute(*line))
    {
      this->Keep(attribute);
      attribute = {};
    }
    else if (attribute.count.empty() && !right.empty() && line->compare(0, 4, "name") == 0)
    {
      attribute.name = right;
    }
    else if (attribute.count.empty() && !right.empty() && line->compare(0, 5, "count") == 0)
    {
      attribute.count = right;
    }
    else
    {
      attribute.value += *line + '\n';
    }
  }
  this->Keep(attribute);
  if (lines.EndInALine())
  {
    FailToRead(path, "a line end behind the last number", "the end of the file");
  }
}

/// A text is between ' and ~.
void AfniHeader::Keep(const Attribute& attribute)
{
  const std::string value = Trimmed(attribute.value);
  const bool isText = !value.empty() && value.front() == '\'';
  const bool isWhole = isText ? value.find('~') != std::string::npos
                              : std::to_string(Words(value).size()) == attribute.count;
  if (!attribute.count.empty() && !isWhole)
  {
    FailToRead(this->path,
      attribute.count + (isText ? " characters as " : " numbers as ") + attribute.name,
      "only " + Quoted(value));
  }
  this->fields.Set(attribute.name, isText ? value.substr(1, value.find('~') - 1) : value);
}

std::vector<double> AfniHeader::Numbers(const std::string& name, std::size_t count) const
{
  const std::vector<std::string> words = Words(this->Text(name));
  if (words.size() < count)
  {
    FailToRead(
      this->path, std::to_string(count) + " numbers as " + name, std::to_string(words.size()));
  }
  std::vector<double> numbers;
  for (const std::string& word : words)
  {
    numbers.push_back(NumberFromText(this->path, "numbers as " + name, word));
  }
  return numbers;
}

/// The layout of a brick, whose type may differ from that of others.
VoxelLayout LayoutOf(const AfniHeader& header, std::int64_t code)
{
  const std::vector<double> dimensions = header.Numbers("DATASET_DIMENSIONS", 3);
  VoxelLayout layout = { {}, VTK_VOID };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    layout.dimensions[axis] = WholeNumber(dimensions[axis]);
  }
  switch (code)
  {
    case 0:
      layout.scalarType = VTK_UNSIGNED_CHAR;
      break;
    case 1:
      layout.scalarType = VTK_SHORT;
      break;
    case 2:
      layout.scalarType = VTK_INT;
      break;
    case 3:
      layout.scalarType = VTK_FLOAT;
      break;
    case 4:
      layout.scalarType = VTK_DOUBLE;
      break;
    case 6:
      layout.scalarType = VTK_UNSIGNED_CHAR;
      layout.componentCount = 3;
      break;
    default:
      FailToRead(header.Path(), "a brick of real numbers or colours (type 0 to 4, or 6)",
        "the type " + std::to_string(code));
  }
  return layout;
}

/// Geometry in AFNI's space, which is LPS.
ImageGeometry GeometryOf(const AfniHeader& header)
{
  ImageGeometry geometry;
  if (header.Has("IJK_TO_DICOM_REAL"))
  {
    const std::vector<double> rows = header.Numbers("IJK_TO_DICOM_REAL", 12);
    for (int row = 0; row < 3; ++row)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        geometry.axesMm[axis][row] = rows[std::size_t(4 * row + axis)];
      }
      geometry.originMm[row] = rows[std::size_t(4 * row + 3)];
    }
    return geometry;
  }
  const std::vector<double> orientation = header.Numbers("ORIENT_SPECIFIC", 3);
  const std::vector<double> origin = header.Numbers("ORIGIN", 3);
  const std::vector<double> step = header.Numbers("DELTA", 3);
  geometry.axesMm = glm::dmat3(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    // 0 and 1 are right and left, 2 and 3 back and front, 4 and 5 feet and head; the step has the
    // sign.
    const double code = orientation[std::size_t(axis)];
    if (!(code >= 0.0 && code <= 5.0))
    {
      FailToRead(header.Path(), "0 to 5 as ORIENT_SPECIFIC", std::to_string(code));
    }
    geometry.axesMm[axis][int(code) / 2] = step[std::size_t(axis)];
    geometry.originMm[int(code) / 2] = origin[std::size_t(axis)];
  }
  return geometry;
}

/// The times of the bricks; numbers if they are a list.
VolumeTimes TimesOf(const AfniHeader& header)
{
  const std::int64_t count = WholeNumber(header.Numbers("DATASET_RANK", 2)[1]);
  if (!header.Has("TAXIS_NUMS") || !header.Has("TAXIS_FLOATS"))
  {
    return NumberedTimes(count);
  }
  constexpr double Milliseconds = 77001.0;
  constexpr double Seconds = 77002.0;
  const double unit = header.Numbers("TAXIS_NUMS", 3)[2];
  const double seconds = unit == Milliseconds ? 1e-3 : unit == Seconds ? 1.0 : 0.0;
  const std::vector<double> startAndStep = header.Numbers("TAXIS_FLOATS", 2);
  return EvenTimes(count, seconds * startAndStep[0], seconds * startAndStep[1]);
}

/// The factor of a brick; 0 means none.
Rescale RescaleOf(const AfniHeader& header, std::int64_t brick)
{
  const auto index = std::size_t(brick);
  const double factor =
    header.Has("BRICK_FLOAT_FACS") ? header.Numbers("BRICK_FLOAT_FACS", index + 1)[index] : 0.0;
  return { factor == 0.0 ? 1.0 : factor, 0.0 };
}

/// The path with another extension, for image.HEAD, image.BRIK and image.BRIK.gz.
std::string WithExtension(const std::string& path, const std::string& extension)
{
  std::filesystem::path changed = path;
  if (LowerCase(changed.extension()) == ".gz")
  {
    changed.replace_extension();
  }
  return changed.replace_extension(extension).string();
}

/// Bytes of the bricks before one.
std::int64_t BytesBefore(
  const AfniHeader& header, const std::vector<double>& types, std::int64_t brick)
{
  std::map<double, std::int64_t> countOfTypes;
  std::for_each(types.begin(), types.begin() + brick, [&](double type) { ++countOfTypes[type]; });
  std::int64_t bytes = 0;
  for (const auto& [type, count] : countOfTypes)
  {
    const VoxelLayout layout = LayoutOf(header, WholeNumber(type));
    bytes += count * std::int64_t(CheckedByteCount(header.Path(), layout));
  }
  return bytes;
}

VoxelFile VoxelFileOf(const AfniHeader& header, Volume& volume)
{
  VoxelFile file;
  const std::string plain = WithExtension(header.Path(), ".BRIK");
  file.paths = { std::filesystem::exists(plain + ".gz") ? plain + ".gz" : plain };
  ReadableFileSize(file.paths.front());
  file.compression = CompressionOf(file.paths.front());
  file.bigEndian = header.Text("BYTEORDER_STRING") == "MSB_FIRST";
  if (!header.Has("BYTEORDER_STRING"))
  {
    volume.warnings.push_back(UnknownByteOrder);
  }
  return file;
}

}

bool IsAfni(const std::string& head)
{
  const std::string begin = Trimmed(head);
  return BeginsAttribute(begin.substr(0, begin.find('\n')));
}

Volume ReadAfni(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  ReadableFileSize(path);
  const AfniHeader header(WithExtension(path, ".HEAD"));
  Volume volume;
  TakeTimes(path, TimesOf(header), options, volume);
  const auto brick = std::size_t(options.time);
  const std::vector<double> types = header.Numbers("BRICK_TYPES", brick + 1);
  const VoxelLayout layout = LayoutOf(header, WholeNumber(types[brick]));
  const ImageGeometry geometry = GeometryOf(header);
  const Rescale rescale = RescaleOf(header, options.time);
  VoxelFile file = VoxelFileOf(header, volume);
  file.dataOffset = BytesBefore(header, types, options.time);
  file.kept = StreamOf(options);
  volume.image = ReadVoxels(file, layout, progress);
  volume.image = Rescaled(path, volume.image, { rescale });
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
