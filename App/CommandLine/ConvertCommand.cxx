#include "Commands.h"

namespace varimarch
{

void RunConvert(const ConvertArguments& arguments)
{
  CheckVolumeOutput(arguments.output, "OUTPUT");
  VolumeSource source = SourceOf(arguments.volume, arguments.volume.input);
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    file->rectified = file->rectified.value_or(false); // values are kept
  }
  WriteVolumeReporting(LoadVolumeReporting(source), arguments.output);
}

}
