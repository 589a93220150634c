// Builds the scenes of the parts of a mixture.

#include "Core/Recipe/ShaderRecipe.h"
#include "March/Processor/PacketSceneBuilder.h"

#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// The colours of dependent components. The last component has the opacity.
PacketColors ColorsOf(
  const VolumeMarch& march, const VolumeResources& volume, const VolumeParameters& parameters)
{
  PacketColors colors = {};
  if (march.settings.components == Components::LuminanceOpacity)
  {
    colors.count = 1;
    colors.look = LookOf(march, volume, parameters, 0, 0);
  }
  else if (march.settings.components == Components::Rgba)
  {
    colors.count = 3;
  }
  for (int component = 0; component < colors.count; ++component)
  {
    colors.voxels[component] = volume.Packets().Voxels(component)->GetVoidPointer(0);
  }
  return colors;
}

// The index of the table that has a part's opacities.
std::size_t OpacityTableOf(const VolumeResources& volume, int component)
{
  const std::vector<MaterialTable>& tables = volume.Materials().MaterialTables();
  const auto decides = [&](const MaterialTable& table)
  { return table.decidesOnOpacity && table.component == component; };
  return std::size_t(std::find_if(tables.begin(), tables.end(), decides) - tables.begin());
}

}

bool IsMixture(const Frame& frame)
{
  return !frame.others.empty() || frame.settings.uneven ||
    frame.settings.components != Components::One;
}

std::vector<PacketScene> ConstituentsOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketScene& scene)
{
  std::vector<PacketScene> constituents;
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    const int component = OpacityComponentOf(march.settings, part);
    PacketScene one = scene;
    one.volume.voxels = volume.Packets().Voxels(component)->GetVoidPointer(0);
    if (march.settings.functionOf == FunctionOf::Value)
    {
      one.look =
        LookOf(march, volume, scene.parameters, OpacityTableOf(volume, component), component);
    }
    one.colors = ColorsOf(march, volume, scene.parameters);
    one.shadows = volume.Light().Shadows(march, part);
    one.constituent.isOfMixture = true;
    one.constituent.component = part;
    one.constituent.isOfSameBricks = part > 0;
    constituents.push_back(one);
  }
  return constituents;
}

}
