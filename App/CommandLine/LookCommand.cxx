#include "Commands.h"

#include "ArgumentChecks.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "UsageError.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>

namespace varimarch
{

namespace
{

void CheckLookOutput(const LookArguments& arguments)
{
  const std::string name = vtksys::SystemTools::LowerCase(arguments.output);
  const std::vector<std::string> extensions = WritableLookExtensions();
  const bool isKnown = std::any_of(extensions.begin(), extensions.end(),
    [&](const std::string& extension)
    { return vtksys::SystemTools::StringEndsWith(name, extension.c_str()); });
  if (!isKnown)
  {
    throw UsageError("OUTPUT: expected a name that ends with " +
      vtksys::SystemTools::Join(extensions, ", ") + ", found " + arguments.output);
  }
  CheckMayReplace(arguments.output, arguments.overwrites);
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
