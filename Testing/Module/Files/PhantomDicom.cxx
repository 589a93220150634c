#include "PhantomDicom.h"

#include <zlib.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <locale>
#include <sstream>

namespace phantom_dicom
{
namespace
{

const std::string ctImageStorage = "1.2.840.10008.5.1.4.1.1.2";
constexpr std::uint32_t UndefinedLength = 0xffffffff;
constexpr std::uint32_t Item = 0xfffee000;
constexpr std::uint32_t EndOfItems = 0xfffee0dd;

template <class Value>
std::string Bytes(Value value)
{
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string TagBytes(std::uint32_t tag)
{
  return Bytes(std::uint16_t(tag >> 16)) + Bytes(std::uint16_t(tag));
}

std::string ItemBytes(std::uint32_t tag, const std::string& content)
{
  return TagBytes(tag) + Bytes(std::uint32_t(content.size())) + content;
}

std::string ElementBytes(std::uint32_t tag, const Element& element)
{
  std::string value = element.value;
  if (value.size() % 2 == 1)
  {
    const bool isText = element.type != "UI" && element.type != "OB";
    value += isText ? ' ' : '\0';
  }
  const std::string start = TagBytes(tag) + element.type;
  const bool isLong = element.type == "OB" || element.type == "OW" || element.type == "SQ";
  if (element.isEncapsulated)
  {
    return start + Bytes(std::uint16_t(0)) + Bytes(UndefinedLength) + value +
      ItemBytes(EndOfItems, "");
  }
  return isLong ? start + Bytes(std::uint16_t(0)) + Bytes(std::uint32_t(value.size())) + value
                : start + Bytes(std::uint16_t(value.size())) + value;
}

std::string AllBytes(const Elements& elements)
{
  std::string all;
  for (const auto& [tag, element] : elements)
  {
    all += ElementBytes(tag, element);
  }
  return all;
}

/// Deflated bytes without header (RFC 1951).
std::string Deflated(const std::string& bytes)
{
  constexpr int WithoutHeader = -15;
  z_stream stream = {};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, WithoutHeader, 8, Z_DEFAULT_STRATEGY);
  std::string deflated(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(deflated.data());
  stream.avail_out = uInt(deflated.size());
  deflate(&stream, Z_FINISH);
  deflated.resize(stream.total_out);
  deflateEnd(&stream);
  return deflated;
}

/// Bytes as literal runs of PS3.5, annex G.3.
std::string LiteralRuns(const std::string& bytes)
{
  constexpr std::size_t LongestRun = 128;
  std::string runs;
  for (std::size_t i = 0; i < bytes.size(); i += LongestRun)
  {
    const std::string run = bytes.substr(i, LongestRun);
    runs += char(run.size() - 1) + run;
  }
  return runs.size() % 2 ? runs + '\x80' : runs; // a byte that means nothing
}

}

Element Text(const std::string& type, const std::string& text)
{
  return { type, text };
}

Element Decimals(const std::vector<double>& numbers)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9); // a number has at most 16 characters
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    text << (i ? "\\" : "") << numbers[i];
  }
  return { "DS", text.str() };
}

Element Shorts(const std::vector<int>& numbers)
{
  std::string bytes;
  for (const int number : numbers)
  {
    bytes += Bytes(std::uint16_t(number));
  }
  return { "US", bytes };
}

Element Sequence(const std::vector<Elements>& items)
{
  std::string bytes;
  for (const Elements& item : items)
  {
    bytes += ItemBytes(Item, AllBytes(item));
  }
  return { "SQ", bytes };
}

Element Pixels(const std::vector<int>& values)
{
  return { "OW", Shorts(values).value };
}

Element RunLengthPixels(const std::vector<int>& values, int fragmentCount)
{
  std::string high;
  std::string low;
  for (const int value : values)
  {
    high += char(value >> 8);
    low += char(value);
  }
  const std::string first = LiteralRuns(high);
  std::string header =
    Bytes(std::uint32_t(2)) + Bytes(std::uint32_t(64)) + Bytes(std::uint32_t(64 + first.size()));
  header.resize(64);
  const std::string frame = header + first + LiteralRuns(low);
  const std::size_t size = (frame.size() / std::size_t(fragmentCount) + 1) / 2 * 2;
  std::string items = ItemBytes(Item, "");
  for (std::size_t i = 0; i < frame.size(); i += size)
  {
    items += ItemBytes(Item, frame.substr(i, size));
  }
  return { "OB", items, true };
}

namespace
{

/// Attributes of what was scanned, and how.
Elements ScanElements(int slice, const DicomOptions& options)
{
  Elements elements = {
    { 0x00080016, Text("UI", ctImageStorage) },
    { 0x00080018,
      Text("UI", options.seriesUid + "." + std::to_string(slice + 1 + options.instance)) },
    { 0x00080060, Text("CS", options.modality) },
    { 0x00100010, Text("PN", "Doe^Jane") },
    { 0x0020000d, Text("UI", "1.2") },
    { 0x0020000e, Text("UI", options.seriesUid) },
    // The numbers contradict the order of the positions: readers must not rely on them.
    { 0x00200013, Text("IS", std::to_string((slice * 7) % 5)) },
  };
  const auto addText = [&](std::uint32_t tag, const std::string& type, const std::string& text)
  {
    if (!text.empty())
    {
      elements[tag] = Text(type, text);
    }
  };
  addText(0x0008103e, "LO", options.description);
  addText(0x00180010, "LO", options.contrastAgent);
  addText(0x00180015, "CS", options.bodyPart);
  addText(0x00180025, "CS", options.isAngiography ? "Y" : "");
  addText(
    0x00180080, "DS", options.repetitionMs > 0.0 ? Decimals({ options.repetitionMs }).value : "");
  addText(0x00180081, "DS", options.echoMs > 0.0 ? Decimals({ options.echoMs }).value : "");
  addText(0x00282110, "CS", options.lossy ? "01" : "");
  return elements;
}

/// Attributes of the pixels and their values.
Elements PixelElements(const StoredVolume& volume, int slice, const DicomOptions& options)
{
  const std::size_t sliceValues = std::size_t(volume.dimensions[0]) * volume.dimensions[1];
  const auto begin = volume.values.begin() + std::ptrdiff_t(slice * sliceValues);
  return {
    { 0x00280002, Shorts({ 1 }) },
    { 0x00280004, Text("CS", "MONOCHROME2") },
    { 0x00280010, Shorts({ options.rows ? options.rows : volume.dimensions[1] }) },
    { 0x00280011, Shorts({ volume.dimensions[0] }) },
    { 0x00280030, Decimals({ glm::length(volume.axesMm[1]), glm::length(volume.axesMm[0]) }) },
    { 0x00280100, Shorts({ 16 }) },
    { 0x00280101, Shorts({ 16 }) },
    { 0x00280102, Shorts({ 15 }) },
    { 0x00280103, Shorts({ 1 }) },
    { 0x00281050, Text("DS", "40") },
    { 0x00281051, Text("DS", "400") },
    { 0x00281052, Decimals({ options.intercept }) },
    { 0x00281053, Decimals({ options.slope }) },
    { 0x7fe00010, Pixels(std::vector<int>(begin, begin + std::ptrdiff_t(sliceValues))) },
  };
}

}

Elements SliceElements(const StoredVolume& volume, int slice, const DicomOptions& options)
{
  const glm::dvec3 position = volume.originMm + volume.axesMm[2] * double(slice);
  const glm::dvec3 row = glm::normalize(volume.axesMm[0]);
  const glm::dvec3 column = glm::normalize(volume.axesMm[1]);
  Elements elements = PixelElements(volume, slice, options);
  elements.merge(ScanElements(slice, options));
  elements[0x00200032] = options.position.empty() ? Decimals({ position.x, position.y, position.z })
                                                  : Text("DS", options.position);
  elements[0x00200037] = Decimals({ row.x, row.y, row.z, column.x, column.y, column.z });
  return elements;
}

std::string FileBytes(const Elements& elements, const std::string& syntax)
{
  const Elements identity = { { 0x00020001, { "OB", std::string("\0\1", 2) } },
    { 0x00020002, elements.at(0x00080016) }, { 0x00020003, elements.at(0x00080018) },
    { 0x00020010, Text("UI", syntax) }, { 0x00020012, Text("UI", "1.2.3.4") } };
  const std::string meta = AllBytes(identity);
  const std::string length = ElementBytes(0x00020000, { "UL", Bytes(std::uint32_t(meta.size())) });
  const std::string content = AllBytes(elements);
  return std::string(128, '\0') + "DICM" + length + meta +
    (syntax == DeflatedSyntax ? Deflated(content) : content);
}

namespace
{

/// An entry of an index, with the file offsets of the next entry and of the first one below it.
std::string IndexRecord(std::uint32_t next, std::uint32_t below, const Elements& keys)
{
  Elements record = keys;
  record[0x00041400] = { "UL", Bytes(next) };
  record[0x00041410] = Shorts({ 0xffff });
  record[0x00041420] = { "UL", Bytes(below) };
  return ItemBytes(Item, AllBytes(record));
}

}
}

std::string DicomBytes(const StoredVolume& volume, int slice, const DicomOptions& options)
{
  return phantom_dicom::FileBytes(phantom_dicom::SliceElements(volume, slice, options));
}

std::string DicomIndexBytes(const std::vector<std::string>& imageNames)
{
  using namespace phantom_dicom;
  const Elements identity = { { 0x00080016, Text("UI", "1.2.840.10008.1.3.10") },
    { 0x00080018, Text("UI", "1.2.3.9") } };
  const std::string meta = [&]
  {
    const std::string bytes = FileBytes(identity);
    return bytes.substr(0, bytes.size() - AllBytes(identity).size());
  }();
  // The offsets of the first and last record, a meaningless element, and the header of the sequence
  // lie between the file's meta information and its first record.
  const auto first = std::uint32_t(meta.size() + 12 + 12 + 10 + 12);
  const auto end = [&](const std::string& records)
  { return std::uint32_t(first + records.size()); };

  std::string records;
  const auto addParent = [&](Elements keys)
  {
    const std::string unplaced = IndexRecord(0, 0, keys);
    records += IndexRecord(0, end(records + unplaced), keys);
  };
  addParent({ { 0x00041430, Text("CS", "PATIENT") }, { 0x00100010, Text("PN", "Doe^Jane") } });
  addParent({ { 0x00041430, Text("CS", "STUDY") }, { 0x0020000d, Text("UI", "1.2") } });
  addParent({ { 0x00041430, Text("CS", "SERIES") }, { 0x00080060, Text("CS", "CT") },
    { 0x0020000e, Text("UI", "1.2.3") } });
  for (const std::string& name : imageNames)
  {
    const Elements keys = { { 0x00041430, Text("CS", "IMAGE") }, { 0x00041500, Text("CS", name) } };
    const std::string unplaced = IndexRecord(0, 0, keys);
    const bool isLast = &name == &imageNames.back();
    records += IndexRecord(isLast ? 0 : end(records + unplaced), 0, keys);
  }
  return meta + ElementBytes(0x00041200, { "UL", Bytes(first) }) +
    ElementBytes(0x00041202, { "UL", Bytes(first) }) + ElementBytes(0x00041212, Shorts({ 0 })) +
    ElementBytes(0x00041220, { "SQ", records });
}
