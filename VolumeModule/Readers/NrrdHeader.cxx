#include "Readers/NrrdHeader.h"

#include "Readers/FileError.h"

#include <algorithm>

namespace varimarch
{
namespace
{

/// Parses one header line: a field, a comment, or a key/value pair.
void TakeLine(NrrdHeader& header, const std::string& line)
{
  const std::size_t colon = line.find(':');
  if (line[0] == '#' || line.compare(std::min(colon, line.size()), 2, ":=") == 0)
  {
    return; // a comment or a key/value pair
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
