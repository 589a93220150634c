// The formats, archives and compressed streams that other libraries parse, as a decoder reads them.
// The header of a VTI file is read here: files whose voxels need no decoding are mapped.
#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Decoder/ImageForm.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Packed/Unpacking.h"
#include "Readers/Paging/MappedVoxels.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VolumeFile.h"

#include <vtkDataArray.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstdint>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// The start tag of an element; empty unless the text has exactly one.
std::string TagOf(const std::string& text, const std::string& element)
{
  const std::string begin = "<" + element + " ";
  const std::size_t place = text.find(begin);
  const bool isAlone =
    place != std::string::npos && text.find(begin, place + 1) == std::string::npos;
  return isAlone ? text.substr(place, text.find('>', place) - place) : "";
}

std::string AttributeOf(const std::string& tag, const std::string& name)
{
  const std::string begin = " " + name + "=\"";
  const std::size_t place = tag.find(begin);
  if (place == std::string::npos)
  {
    return "";
  }
  const std::size_t first = place + begin.size();
  return tag.substr(first, tag.find('"', first) - first);
}

/// The numbers of an attribute; empty unless there are `count`.
std::vector<double> NumbersOf(const std::string& tag, const std::string& name, std::size_t count)
{
  std::istringstream stream(AttributeOf(tag, name));
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number; stream >> number;)
  {
    numbers.push_back(number);
  }
  return numbers.size() == count && stream.eof() ? numbers : std::vector<double>();
}

/// The header of the one kind of file that is mapped.
struct VtiHeader
{
  std::string file; ///< start tags of elements
  std::string image;
  std::string piece;
  std::string array;
  std::uint64_t appended = 0; ///< offset in the file of the first byte of appended data
};

/// The header; none if the file may be of another kind.
std::optional<VtiHeader> HeaderOf(const std::string& path)
{
  constexpr std::size_t MostBytes = 1 << 16;
  std::string text(MostBytes, '\0');
  text.resize(OpenStream(path, Compression::None)->Read(text.data(), text.size()));
  const std::size_t end = text.find("<AppendedData ");
  const std::size_t mark = text.find('_', end);
  if (end == std::string::npos || mark == std::string::npos ||
    AttributeOf(text.substr(end, mark - end), "encoding") != "raw")
  {
    return std::nullopt;
  }
  text.resize(end);
  VtiHeader header{ TagOf(text, "VTKFile"), TagOf(text, "ImageData"), TagOf(text, "Piece"),
    TagOf(text, "DataArray"), mark + 1 };
  const bool isOfPoints = text.find("<DataArray") < text.find("</PointData");
  const std::string extent = AttributeOf(header.image, "WholeExtent");
  const bool isKnown = isOfPoints && !extent.empty() &&
    extent == AttributeOf(header.piece, "Extent") &&
    AttributeOf(header.file, "type") == "ImageData" &&
    AttributeOf(header.file, "compressor").empty() &&
    AttributeOf(header.array, "format") == "appended";
  return isKnown ? std::optional(header) : std::nullopt;
}

int ScalarTypeOfName(const std::string& name)
{
  static const std::map<std::string, int> types = { { "Int8", VTK_SIGNED_CHAR },
    { "UInt8", VTK_UNSIGNED_CHAR }, { "Int16", VTK_SHORT }, { "UInt16", VTK_UNSIGNED_SHORT },
    { "Float32", VTK_FLOAT } };
  const auto type = types.find(name);
  return type == types.end() ? VTK_VOID : type->second;
}

/// The layout; none if it cannot be mapped.
std::optional<VoxelLayout> LayoutOf(const VtiHeader& header)
{
  const std::vector<double> extent = NumbersOf(header.image, "WholeExtent", 6);
  const std::string components = AttributeOf(header.array, "NumberOfComponents");
  VoxelLayout layout{ {}, ScalarTypeOfName(AttributeOf(header.array, "type")) };
  if (extent.empty() || layout.scalarType == VTK_VOID || !(components.empty() || components == "1"))
  {
    return std::nullopt;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    layout.dimensions[axis] = WholeNumber(extent[2 * axis + 1] - extent[2 * axis]) + 1;
  }
  return layout;
}

/// The number of bytes in front of the array in the appended data, which its own byte count takes.
std::uint64_t CountBytes(const VtiHeader& header)
{
  return AttributeOf(header.file, "header_type") == "UInt64" ? 8 : 4;
}

/// Where the voxels are. The file must state their number of bytes in front of them.
VoxelFile VoxelFileOf(const std::string& path, const VtiHeader& header, const VoxelLayout& layout,
  const Mapping& mapping)
{
  const std::vector<double> begin = NumbersOf(header.array, "offset", 1);
  VoxelFile file;
  file.paths = { path };
  file.bigEndian = AttributeOf(header.file, "byte_order") == "BigEndian";
  file.mapping = mapping;
  const auto place = std::uint64_t(
    std::int64_t(header.appended) + WholeNumber(begin.empty() ? 0.0 : std::max(0.0, begin[0])));
  std::uint64_t stated = 0;
  OpenStream(path, Compression::None, place)->Read(&stated, std::size_t(CountBytes(header)));
  const std::uint64_t expected = ByteCountOf(path, layout);
  if (begin.empty() || (file.bigEndian == HostIsBigEndian && stated != expected))
  {
    FailToRead(path, std::to_string(expected) + " bytes of voxels", std::to_string(stated));
  }
  file.dataOffset = std::int64_t(place + CountBytes(header));
  return file;
}

ImageGeometry GeometryOf(const VtiHeader& header)
{
  const auto numbers = [&](const char* name, std::vector<double> usual)
  {
    const std::vector<double> found = NumbersOf(header.image, name, usual.size());
    return found.empty() ? usual : found;
  };
  const std::vector<double> origin = numbers("Origin", { 0.0, 0.0, 0.0 });
  const std::vector<double> spacing = numbers("Spacing", { 1.0, 1.0, 1.0 });
  const std::vector<double> rows =
    numbers("Direction", { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 });
  const std::vector<double> extent = NumbersOf(header.image, "WholeExtent", 6);
  ImageGeometry geometry;
  const glm::dmat3 direction = glm::transpose(glm::make_mat3(rows.data()));
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] = direction[axis] * spacing[std::size_t(axis)];
  }
  geometry.originMm =
    glm::make_vec3(origin.data()) + geometry.axesMm * glm::dvec3(extent[0], extent[2], extent[4]);
  return geometry;
}

/// The volume of a VTI file whose voxels stay in it, because they are too many for the memory and
/// the file has them as they are there: one piece with one array, appended raw and uncompressed, as
/// vtkXMLImageDataWriter writes it with EncodeAppendedDataOff and SetCompressorTypeToNone. None for
/// any other file.
/// @throws std::runtime_error if such a file is too short or its geometry is not valid
/// @throws ReadCancelled
std::optional<Volume> MappedVti(
  const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const Mapping mapping = MappingOf(options);
  const std::uint64_t most = mapping.mostMemoryBytes;
  if (ReadableFileSize(path) <= most / 4 || CompressionOf(path) != Compression::None)
  {
    return std::nullopt;
  }
  const std::optional<VtiHeader> header = HeaderOf(path);
  const std::optional<VoxelLayout> layout = header ? LayoutOf(*header) : std::nullopt;
  if (!layout || ByteCountOf(path, *layout) <= most / 4)
  {
    return std::nullopt;
  }
  Volume volume;
  volume.image = ReadVoxels(VoxelFileOf(path, *header, *layout, mapping), *layout, progress);
  PlaceImage(path, GeometryOf(*header), volume.image);
  return volume;
}

Volume TakeVolume(const std::string& path, Conversation& conversation)
{
  Volume volume;
  ImageForm form;
  TakeValues(conversation.Result(), volume, form);
  if (!IsNumberType(form.layout.scalarType))
  {
    throw DecoderFailure{ "voxels of the decoder that are no numbers" };
  }
  if (volume.times.values.empty())
  {
    throw DecoderFailure{ "a volume of the decoder without a time" };
  }
  const std::uint64_t byteCount = CheckedByteCount(path, form.layout);
  volume.image = AllocatedImage(form.layout);
  form.Place(volume.image);
  conversation.TakeBytes(volume.image->GetScalarPointer(), byteCount);
  conversation.Finish();
  return volume;
}

Volume ReadByDecoder(const std::string& format, const std::string& path, const ReadOptions& options,
  ReadProgress& progress)
{
  try
  {
    Conversation conversation(path, progress);
    conversation.Give(Packed(Job::ReadFormat, FreeJobMemory(), format, path, options));
    return TakeVolume(path, conversation);
  }
  catch (const DecoderFailure& failure)
  {
    FailToDecode(path, failure);
  }
}

}

Volume ReadImageStack(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("image stack", path, options, progress);
}

Volume ReadInv3(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("InVesalius", path, options, progress);
}

Volume ReadMinc(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("MINC", path, options, progress);
}

Volume ReadPvti(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("PVTI", path, options, progress);
}

Volume ReadSegmentation(const std::string& path, ReadProgress& progress)
{
  return ReadByDecoder("DICOM segmentation", path, {}, progress);
}

Volume ReadTiff(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("TIFF", path, options, progress);
}

Volume ReadVti(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  std::optional<Volume> mapped = MappedVti(path, options, progress);
  return mapped ? *mapped : ReadByDecoder("VTI", path, options, progress);
}

namespace
{

/// The bytes that a decoder decompresses.
class DecodedStream : public ByteStream
{
public:
  DecodedStream(const std::string& path, std::uint64_t offset)
    : path(path)
    , silent([](double) { return true; })
    , conversation(path, this->silent)
  {
    this->Try(
      [&]
      {
        this->conversation.Give(Packed(Job::Decompress, FreeJobMemory(), path, offset));
        this->conversation.Result();
      });
  }

  ~DecodedStream() override
  {
    if (!this->ended)
    {
      this->conversation.Cancel();
    }
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    while (done < count && !this->ended)
    {
      const std::size_t taken = std::min(count - done, this->part.count);
      std::copy_n(this->part.begin, taken, static_cast<char*>(buffer) + done);
      this->part.begin += taken;
      this->part.count -= taken;
      done += taken;
      if (this->part.count == 0 && done < count)
      {
        this->Try([&] { this->part = this->conversation.NextBytes(); });
        this->ended = this->part.count == 0;
        this->fileBytes = std::max(this->fileBytes, this->part.fileBytes);
      }
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->fileBytes; }

private:
  /// A stream that has failed has ended.
  template <class Action>
  void Try(const Action& action)
  {
    this->ended = true;
    try
    {
      action();
      this->ended = false;
    }
    catch (const DecoderFailure& failure)
    {
      FailToDecode(this->path, failure);
    }
  }

  std::string path;
  ReadProgress silent;
  Conversation conversation;
  DecoderBytes part = { nullptr, 0, 0 };
  std::uint64_t fileBytes = 0;
  bool ended = false;
};

}

std::unique_ptr<ByteStream> OpenArchiveStream(const std::string& path, std::uint64_t offset)
{
  return std::make_unique<DecodedStream>(path, offset);
}

UnpackedContent Unpack(const UnpackingOrder& order, ReadProgress& progress)
{
  return Answer<UnpackedContent>(order.path, Packed(Job::Unpack, FreeJobMemory(), order), progress);
}

}
