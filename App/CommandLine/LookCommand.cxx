#include "Commands.h"

#include "Scene/LookFiles.h"
#include "Scene/Presets.h"
#include "Scene/VolumeProperty.h"
#include "UsageError.h"

#include <vtksys/SystemTools.hxx>

#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

void CheckLookOutput(const LookArguments& arguments)
{
  const std::string name = vtksys::SystemTools::LowerCase(arguments.output);
  std::string extensions;
  bool isKnown = false;
  for (const LookFileFormat& format : LookFileFormats())
  {
    if (format.canBeWritten)
    {
      isKnown = isKnown || vtksys::SystemTools::StringEndsWith(name, format.extension.c_str());
      extensions += (extensions.empty() ? "" : ", ") + format.extension;
    }
  }
  if (!isKnown)
  {
    throw UsageError(
      "OUTPUT: expected a name that ends with " + extensions + ", found " + arguments.output);
  }
  if (!arguments.overwrites && std::filesystem::exists(arguments.output))
  {
    throw std::runtime_error(arguments.output + ": exists already; --overwrite replaces it");
  }
}

}

void RunLook(const LookArguments& arguments)
{
  CheckLookOutput(arguments);
  const auto [scene, volume] = LoadScene(arguments.scene);
  Preset preset = PresetOf(scene);
  preset.look = InUnitsOfData(preset.look, volume.image);
  WriteLookFile(preset, arguments.output, ContextOf(volume.image));
}

}
