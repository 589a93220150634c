#include "Commands.h"

#include "Messages.h"
#include "Progress.h"
#include "Scene/VolumeWriters/VolumeWriters.h"
#include "UsageError.h"
#include "VtkMessages.h"

#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

/// A list such as ".nii, .nii.gz, .nrrd".
std::string WritableExtensions()
{
  std::string list;
  for (const VolumeWriter& writer : VolumeWriters())
  {
    for (const std::string& extension : writer.extensions)
    {
      list += (list.empty() ? "" : ", ") + extension;
    }
  }
  return list;
}

// Rejects an output that cannot be written, before a volume is read for it.
void CheckOutput(const ConvertArguments& arguments)
{
  const std::string& path = arguments.outputPath;
  if (!WriterFor(path))
  {
    throw UsageError(
      "OUTPUT: expected a name that ends with " + WritableExtensions() + ", found " + path);
  }
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error(path + ": expected the name of a file, found a folder");
  }
  if (!arguments.overwrites && std::filesystem::exists(path))
  {
    throw std::runtime_error(path + ": exists already; --overwrite replaces it");
  }
}

}

void RunConvert(const ConvertArguments& arguments)
{
  CheckOutput(arguments);
  VolumeSource source = SourceOf(arguments.volume, arguments.volume.input);
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    file->rectified = file->rectified.value_or(false); // values are kept
  }
  const LoadedVolume volume = LoadVolumeReporting(source);
  const Progress progress("Writing " + arguments.outputPath);
  for (const std::string& loss : WriteVolume(volume, arguments.outputPath))
  {
    PrintMessage("warning: " + loss);
  }
  ThrowIfVtkReportedError();
}

}
