#include "Commands.h"

#include "Progress.h"
#include "Scene/Volumes/VariationImage.h"

#include <stdexcept>

namespace varimarch
{

void RunField(const FieldArguments& arguments)
{
  CheckVolumeOutput(arguments.output, "-o");
  const LoadedVolume volume =
    LoadVolumeReporting(SourceOf(arguments.volume, arguments.volume.input));
  LoadedVolume field;
  try
  {
    const Progress progress("Building the field of " + arguments.volume.input);
    field.image = VariationImage(volume.image, arguments.tolerance, arguments.distance);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error(arguments.volume.input + ": " + error.what());
  }
  WriteVolumeReporting(field, arguments.output);
}

}
