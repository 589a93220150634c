#include "Scene/Looks/LookFormats/LookFormats.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace varimarch
{

namespace
{

constexpr int ScaleColors = 256;

struct TableEntry
{
  double index;
  glm::dvec3 rgb; ///< 0 to 255
  double opacity; ///< [0, 1]
  std::string name = {};
  bool isVisible = true;
};

using TableEntries = std::vector<TableEntry>;

bool IsBinaryLut(const std::string& bytes)
{
  return bytes.size() == 3 * ScaleColors || bytes.compare(0, 4, "ICOL") == 0;
}

TableEntries EntriesOfBinary(const std::string& bytes, const std::string& file)
{
  const std::size_t header = bytes.size() == 3 * ScaleColors ? 0 : 32;
  if (bytes.size() < header + 3 * ScaleColors)
  {
    FailToReadLook(file,
      "expected " + std::to_string(header + 3 * ScaleColors) + " bytes of colours, found " +
        std::to_string(bytes.size()));
  }
  const auto component = [&](int channel, int i)
  { return double(static_cast<unsigned char>(bytes[header + channel * ScaleColors + i])); };
  TableEntries entries;
  for (int i = 0; i < ScaleColors; ++i)
  {
    entries.push_back({ double(i), { component(0, i), component(1, i), component(2, i) }, 1.0 });
  }
  return entries;
}

/// Reads the entries of all lines. Comments, empty lines and a line of headings are skipped.
TableEntries EntriesOfLines(const std::string& text, const std::string& file, const char* expected,
  const std::function<bool(std::istream&, TableEntry&)>& readEntry)
{
  TableEntries entries;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#' || std::isalpha(line[first] & 0x7f))
    {
      continue;
    }
    std::istringstream fields(line);
    fields.imbue(std::locale::classic());
    TableEntry entry = { double(entries.size()), glm::dvec3(0.0), 1.0 };
    if (entries.size() > MostLookNodes || !readEntry(fields, entry))
    {
      FailToReadLook(file,
        std::string("expected lines of ") + expected + ", found \"" + line.substr(0, 40) + "\"");
    }
    entries.push_back(entry);
  }
  if (entries.empty())
  {
    FailToReadLook(file, std::string("expected lines of ") + expected + ", found none");
  }
  std::stable_sort(entries.begin(), entries.end(),
    [](const TableEntry& a, const TableEntry& b) { return a.index < b.index; });
  return entries;
}

bool ReadRgb(std::istream& fields, glm::dvec3& rgb)
{
  return bool(fields >> rgb.r >> rgb.g >> rgb.b);
}

/// Three numbers are a colour, four an index and a colour.
bool ReadLutEntry(std::istream& fields, TableEntry& entry)
{
  double first = 0.0;
  double fourth = 0.0;
  if (!(fields >> first >> entry.rgb.r >> entry.rgb.g))
  {
    return false;
  }
  if (fields >> fourth)
  {
    entry.index = first;
    entry.rgb.b = fourth;
    return true;
  }
  entry.rgb = { first, entry.rgb.r, entry.rgb.g };
  return true;
}

bool ReadCtblEntry(std::istream& fields, TableEntry& entry)
{
  const bool isRead = fields >> entry.index >> entry.name && ReadRgb(fields, entry.rgb) &&
    bool(fields >> entry.opacity);
  entry.opacity /= 255.0;
  return isRead;
}

bool ReadLabelEntry(std::istream& fields, TableEntry& entry)
{
  double visible = 1.0;
  double visibleAsMesh = 1.0;
  const bool isRead =
    fields >> entry.index && ReadRgb(fields, entry.rgb) && bool(fields >> entry.opacity >> visible);
  entry.isVisible = visible != 0.0;
  fields >> visibleAsMesh >> std::quoted(entry.name);
  return isRead;
}

Look ScaleOf(const TableEntries& entries, const std::string& file, const LookContext& context)
{
  Look look;
  const double first = entries.front().index;
  const double length = std::max(1.0, entries.back().index - first);
  for (const TableEntry& entry : entries)
  {
    look.colors.push_back({ (entry.index - first) / length, entry.rgb / 255.0 });
  }
  Spread(look, context.smallest, context.largest);
  return CleanLook(look, file, context);
}

/// A label's colour and opacity hold from half a step below its value to half a step above.
Look LabelsOf(const TableEntries& entries, const std::string& file, const LookContext& context)
{
  Look look;
  for (const TableEntry& entry : entries)
  {
    const double ends[] = { entry.index - 0.5, entry.index + 0.5 };
    look.opacities.push_back({ ends[0], 0.0 });
    for (const double end : ends)
    {
      look.colors.push_back({ end, entry.rgb / 255.0 });
      look.opacities.push_back({ end, entry.isVisible ? entry.opacity : 0.0 });
    }
    look.opacities.push_back({ ends[1], 0.0 });
  }
  look.shading.enabled = false;
  return CleanLook(look, file, context);
}

TableEntries EntriesOfCtbl(const std::string& text, const std::string& file)
{
  return EntriesOfLines(text, file, "index, name, red, green, blue and opacity", ReadCtblEntry);
}

TableEntries EntriesOfLabels(const std::string& text, const std::string& file)
{
  return EntriesOfLines(
    text, file, "index, red, green, blue, opacity and visibility", ReadLabelEntry);
}

}

Look LookFromLut(const std::string& bytes, const std::string& file, const LookContext& context)
{
  const TableEntries entries = IsBinaryLut(bytes)
    ? EntriesOfBinary(bytes, file)
    : EntriesOfLines(bytes, file, "red, green and blue", ReadLutEntry);
  return ScaleOf(entries, file, context);
}

Look LookFromCtbl(const std::string& text, const std::string& file, const LookContext& context)
{
  return LabelsOf(EntriesOfCtbl(text, file), file, context);
}

Look LookFromLabelDescriptions(
  const std::string& text, const std::string& file, const LookContext& context)
{
  return LabelsOf(EntriesOfLabels(text, file), file, context);
}

std::vector<Segment> SegmentsFromTable(const std::string& text, const std::string& file)
{
  const bool isQuoted = text.find('"') != std::string::npos;
  const TableEntries entries = isQuoted ? EntriesOfLabels(text, file) : EntriesOfCtbl(text, file);
  const bool hasOpacities = std::any_of(
    entries.begin(), entries.end(), [](const TableEntry& entry) { return entry.opacity > 0.0; });
  std::vector<Segment> segments;
  for (const TableEntry& entry : entries)
  {
    if (std::abs(entry.index) > std::numeric_limits<int>::max() ||
      entry.index != std::floor(entry.index))
    {
      FailToReadLook(
        file, "expected whole numbers as labels, found " + std::to_string(entry.index));
    }
    segments.push_back({ int(entry.index), entry.name,
      glm::clamp(entry.rgb / 255.0, glm::dvec3(0.0), glm::dvec3(1.0)), entry.isVisible,
      hasOpacities ? std::clamp(entry.opacity, 0.0, 1.0) : 1.0 });
  }
  return segments;
}

}
