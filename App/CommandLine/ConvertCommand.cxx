#include "Commands.h"

#include "Messages.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"

namespace varimarch
{

namespace
{

/// Writes a file with chunks as another one, box by box. Returns false for other files.
bool ConvertsByChunks(const VolumeSource& source, const VolumeOutput& output)
{
  const auto* const file = std::get_if<FileSource>(&source);
  if (!file || file->raw || !WriterFor(output.path)->isFolder)
  {
    return false;
  }
  std::vector<std::string> warnings;
  const std::optional<ZarrInput> input = ChunkedInput(*file, warnings);
  for (const std::string& warning : warnings)
  {
    PrintMessage("warning: " + warning);
  }
  if (input)
  {
    WriteChunkedReporting(*input, output);
  }
  return input.has_value();
}

}

void RunConvert(const ConvertArguments& arguments)
{
  CheckVolumeOutput(arguments.output, "OUTPUT");
  VolumeSource source = SourceOf(arguments.volume, arguments.volume.input);
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    file->rectified = file->rectified.value_or(false); // values are kept
  }
  if (ConvertsByChunks(source, arguments.output))
  {
    return;
  }
  WriteVolumeReporting(LoadVolumeReporting(source), arguments.output);
}

}
