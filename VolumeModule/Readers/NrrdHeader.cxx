#include "Readers/NrrdHeader.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"

#include <algorithm>

namespace varimarch
{
namespace
{

/// Parses one header line: a field, a comment, or a key/value pair.
void TakeLine(NrrdHeader& header, const std::string& line)
{
  const std::size_t colon = line.find(':');
  if (line[0] == '#')
  {
    return; // a comment
  }
  if (line.compare(std::min(colon, line.size()), 2, ":=") == 0)
  {
    header.pairs[line.substr(0, colon)] = Trimmed(line.substr(colon + 2));
    return;
  }
  if (colon == std::string::npos)
  {
    FailToRead(header.path, "a NRRD header of lines \"field: value\"", Quoted(line));
  }
  header.fields.Set(
    WithoutBlanks(LowerCase(line.substr(0, colon))), Trimmed(line.substr(colon + 1)));
}

}

std::string WithoutBlanks(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

std::vector<std::string> NrrdParts(const std::string& line)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t", begin)) != std::string::npos)
  {
    const char first = line[begin];
    std::size_t end = line.find_first_of(first == '(' ? ")"
        : first == '"'                                ? "\""
                                                      : " \t",
      begin + 1);
    end = end == std::string::npos ? line.size() : end + (first == '(' || first == '"' ? 1 : 0);
    parts.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

std::vector<std::string> NrrdPartsPerAxis(
  const NrrdHeader& header, const std::vector<std::string>& keys, std::size_t axisCount)
{
  const std::vector<std::string> parts = NrrdParts(header.fields.Value(keys));
  if (!parts.empty() && parts.size() != axisCount)
  {
    FailToRead(header.path, std::to_string(axisCount) + " values for the field " + keys.front(),
      std::to_string(parts.size()));
  }
  return parts;
}

std::vector<double> NrrdVector(
  const NrrdHeader& header, const std::string& what, const std::string& text)
{
  std::string inside = text;
  std::replace_if(
    inside.begin(), inside.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  if (LowerCase(text) == "none" || LowerCase(Words(inside).front()) == "nan")
  {
    return {};
  }
  if (text.empty() || text.front() != '(' || text.back() != ')')
  {
    FailToRead(header.path, "a vector such as (1,0,0) for the " + what, Quoted(text));
  }
  return NumbersFromText(header.path, what, inside, Words(inside).size());
}

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  NrrdHeader header;
  header.path = path;
  HeaderLines lines(path);
  const std::string magic = lines.Next().value_or("");
  if (magic.compare(0, 4, "NRRD") != 0)
  {
    FailToRead(path, "a first line that begins with NRRD", Quoted(magic));
  }
  // The header ends with an empty line, or with the file if the voxels are in another file.
  std::optional<std::string> line = lines.Next();
  for (; line && !line->empty(); line = lines.Next())
  {
    if (IsFileList(header.fields.Value({ "datafile" })))
    {
      header.listedFiles.push_back(Trimmed(*line));
    }
    else
    {
      TakeLine(header, *line);
    }
  }
  if (!line && !header.fields.Has("datafile"))
  {
    FailToRead(path, "an empty line after the NRRD header", "the end of the file");
  }
  header.end = lines.Position();
  return header;
}

}
