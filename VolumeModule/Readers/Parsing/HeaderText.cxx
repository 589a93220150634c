#include "Readers/Parsing/HeaderText.h"

#include "Readers/FileError.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <regex>
#include <sstream>

namespace varimarch
{
namespace
{

/// Path of a file named in a header: absolute, or relative to the header's folder.
std::string PathBeside(const std::string& headerPath, const std::string& name)
{
  return (std::filesystem::path(headerPath).parent_path() / name).string();
}

/// A unit of length by one of its names.
struct NamedLength
{
  const char* name; ///< in small letters, without the letter s of the plural
  double mm;
};

constexpr NamedLength NamedLengths[] = {
  { "", 1.0 },
  { "?", 1.0 },
  { "???", 1.0 }, // not stated
  { "pm", 1e-9 },
  { "picometer", 1e-9 },
  { "picometre", 1e-9 },
  { "angstrom", 1e-7 },
  { "\xc3\x85", 1e-7 },     // the letter A with a ring
  { "\xe2\x84\xab", 1e-7 }, // the sign of the unit
  { "nm", 1e-6 },
  { "nanometer", 1e-6 },
  { "nanometre", 1e-6 },
  { "um", 1e-3 },
  { "micron", 1e-3 },
  { "micrometer", 1e-3 },
  { "micrometre", 1e-3 },
  { "\xb5m", 1e-3 },     // with the micro sign of Latin-1
  { "\xc2\xb5m", 1e-3 }, // with the micro sign
  { "\xce\xbcm", 1e-3 }, // with the Greek letter mu
  { "mm", 1.0 },
  { "millimeter", 1.0 },
  { "millimetre", 1.0 },
  { "cm", 10.0 },
  { "centimeter", 10.0 },
  { "centimetre", 10.0 },
  { "dm", 100.0 },
  { "decimeter", 100.0 },
  { "decimetre", 100.0 },
  { "inch", 25.4 },
  { "inche", 25.4 }, // without the letter s of the plural
  { "in", 25.4 },
  { "thou", 0.0254 },
  { "pt", 25.4 / 72.0 },
  { "ft", 304.8 },
  { "m", 1000.0 },
  { "meter", 1000.0 },
  { "metre", 1000.0 },
};

/// Length of a unit [mm]; nothing for an unknown one.
std::optional<double> LengthOfUnit(const std::string& unit)
{
  std::string name = LowerCase(unit);
  if (name.size() > 3 && name.back() == 's')
  {
    name.pop_back();
  }
  const auto* const length = std::find_if(std::begin(NamedLengths), std::end(NamedLengths),
    [&](const NamedLength& named) { return name == named.name; });
  return length == std::end(NamedLengths) ? std::nullopt : std::optional(length->mm);
}

std::vector<std::string> FilesOfPattern(const std::string& headerPath, const std::string& value)
{
  static const std::regex pattern(R"(([^%]*)%(0?)(\d?)d([^%]*?)\s+(\S+)\s+(\S+)\s+(\S+)(\s+\S+)?)");
  static const std::regex number(R"(%\d*d)");
  std::smatch parts;
  // std::regex recurses for each character, so a long text would exhaust the stack.
  constexpr std::size_t LongestName = 1000;
  if (value.size() > LongestName)
  {
    FailToRead(headerPath, "a file name of at most 1000 characters", Quoted(value));
  }
  if (!std::regex_search(value, number))
  {
    return { PathBeside(headerPath, value) };
  }
  if (!std::regex_match(value, parts, pattern))
  {
    FailToRead(headerPath, "a file pattern such as slice%03d.raw 1 100 1", Quoted(value));
  }
  const std::int64_t first = IntegerFromText(headerPath, "a first file number", parts[5]);
  const std::int64_t last = IntegerFromText(headerPath, "a last file number", parts[6]);
  const std::int64_t step = IntegerFromText(headerPath, "a step of file numbers", parts[7]);
  const double count = step == 0 ? 0.0 : (double(last) - double(first)) / double(step) + 1.0;
  constexpr double LargestNumber = 1e15;
  const bool areSmall =
    std::abs(double(first)) <= LargestNumber && std::abs(double(last)) <= LargestNumber;
  if (!(count >= 1.0 && count <= 1e5 && areSmall))
  {
    FailToRead(headerPath, "a pattern for 1 to 100000 files", Quoted(value));
  }
  std::vector<std::string> files;
  for (std::int64_t i = 0; i < std::int64_t(count); ++i)
  {
    std::ostringstream name;
    name.imbue(std::locale::classic());
    const int width = parts[3].length() ? std::stoi(parts[3]) : 0;
    name << parts[1] << std::internal << std::setfill(parts[2].length() ? '0' : ' ')
         << std::setw(width) << first + i * step << parts[4];
    files.push_back(PathBeside(headerPath, name.str()));
  }
  return files;
}

}

HeaderLines::HeaderLines(const std::string& path)
{
  const std::uint64_t mostBytes = 4 << 20;
  this->text.resize(std::size_t(std::min(mostBytes, ReadableFileSize(path))));
  this->text.resize(
    OpenStream(path, Compression::None)->Read(this->text.data(), this->text.size()));
}

std::optional<std::string> HeaderLines::Next()
{
  if (this->position >= this->text.size())
  {
    return std::nullopt;
  }
  const std::size_t end = std::min(this->text.find('\n', this->position), this->text.size());
  std::string line = this->text.substr(this->position, end - this->position);
  this->position = end + 1;
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return line;
}

std::string HeaderWords::Next()
{
  const auto isSpace = [this](std::size_t place)
  { return std::isspace(static_cast<unsigned char>(this->bytes[place])) != 0; };
  std::size_t begin = std::min(this->position, this->bytes.size());
  while (begin < this->bytes.size() && isSpace(begin))
  {
    ++begin;
  }
  std::size_t end = begin;
  while (end < this->bytes.size() && !isSpace(end))
  {
    ++end;
  }
  this->position = std::min(end + 1, this->bytes.size());
  return this->bytes.substr(begin, end - begin);
}

std::int64_t HeaderWords::Integer(const std::string& what)
{
  return IntegerFromText(this->path, what, this->Next());
}

double HeaderWords::Number(const std::string& what)
{
  return NumberFromText(this->path, what, this->Next());
}

std::string WholeFile(const std::string& path)
{
  const auto fileBytes = std::int64_t(ReadableFileSize(path));
  CheckedByteCount(path, { { fileBytes, 1, 1 }, VTK_UNSIGNED_CHAR });
  std::string bytes(std::size_t(fileBytes), '\0');
  bytes.resize(OpenStream(path, Compression::None)->Read(bytes.data(), bytes.size()));
  return bytes;
}

std::string HeaderFields::Value(const std::vector<std::string>& keys) const
{
  for (const std::string& key : keys)
  {
    const auto field = this->fields.find(key);
    if (field != this->fields.end())
    {
      return field->second;
    }
  }
  return "";
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char character) { return char(std::tolower(character)); });
  return text;
}

std::string Trimmed(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  const std::size_t end = text.find_last_not_of(blanks);
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

bool IsFileList(const std::string& value)
{
  const std::vector<std::string> words = Words(value);
  return !words.empty() && LowerCase(words.front()) == "list";
}

std::vector<std::string> DataFiles(
  const std::string& headerPath, const std::string& value, const std::vector<std::string>& listed)
{
  if (!IsFileList(value))
  {
    return FilesOfPattern(headerPath, value);
  }
  if (listed.empty())
  {
    FailToRead(headerPath, "names of data files after LIST", "none");
  }
  std::vector<std::string> files;
  files.reserve(listed.size());
  for (const std::string& name : listed)
  {
    files.push_back(PathBeside(headerPath, name));
  }
  return files;
}

double MmPerUnit(const std::string& unit)
{
  return LengthOfUnit(unit).value_or(1.0);
}

double MmPerUnitOrWarn(const std::string& unit, std::vector<std::string>& warnings)
{
  const std::string warning =
    "The unit " + Quoted(unit) + " is not known; millimetres were assumed.";
  const bool isNew = std::find(warnings.begin(), warnings.end(), warning) == warnings.end();
  if (!LengthOfUnit(unit) && isNew)
  {
    warnings.push_back(warning);
  }
  return MmPerUnit(unit);
}

}
