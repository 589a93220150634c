#include "VolumeOutput.h"

#include "ArgumentChecks.h"
#include "Messages.h"
#include "Progress.h"
#include "ReportedErrors.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "UsageError.h"

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

}

void CheckVolumeOutput(const VolumeOutput& output, const std::string& argument)
{
  const std::string& path = output.path;
  if (!WriterFor(path))
  {
    throw UsageError(
      argument + ": expected a name that ends with " + WritableExtensions() + ", found " + path);
  }
  if (std::filesystem::is_directory(path) && !WriterFor(path)->isFolder)
  {
    throw std::runtime_error(path + ": expected the name of a file, found a folder");
  }
  CheckMayReplace(path, output.overwrites);
}

void WriteChunkedReporting(const ZarrInput& input, const VolumeOutput& output)
{
  const std::string activity = "Writing " + output.path;
  Progress progress(activity);
  int shown = -1;
  const auto observer = [&](double part)
  {
    const int percent = int(100.0 * part);
    if (percent != shown)
    {
      shown = percent;
      progress.SetActivity(activity + ", " + std::to_string(percent) + " %");
    }
    return true;
  };
  for (const std::string& loss : WriteChunkedVolume(input, output.path, observer))
  {
    PrintMessage("warning: " + loss);
  }
}

void WriteVolumeReporting(const LoadedVolume& volume, const VolumeOutput& output)
{
  const Progress progress("Writing " + output.path);
  for (const std::string& loss : WriteVolume(volume, output.path))
  {
    PrintMessage("warning: " + loss);
  }
  ThrowIfVtkReportedError();
}

}
