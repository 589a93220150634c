// What a mixture is made of, in plain numbers, as packets of rays are marched by it.

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/Lights.h"
#include "March/Processor/PacketSceneBuilder.h"

#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Of dependent components, that of opacities is the last.
PacketColors ColorsOf(
  const Frame& frame, const VolumeResources& volume, const VolumeParameters& parameters)
{
  PacketColors colors = {};
  if (frame.settings.components == Components::LuminanceOpacity)
  {
    colors.count = 1;
    colors.look = LookOf(frame, volume, parameters, 0, 0);
  }
  else if (frame.settings.components == Components::Rgba)
  {
    colors.count = 3;
  }
  for (int component = 0; component < colors.count; ++component)
  {
    colors.voxels[component] = volume.PacketVoxels(component)->GetVoidPointer(0);
  }
  return colors;
}

PacketSpacing SpacingOf(const UnevenBins& uneven)
{
  if (uneven.bins.empty())
  {
    return {};
  }
  return { uneven.bins.data(), uneven.first, uneven.last };
}

// The table of a part's opacities.
std::size_t OpacityTableOf(const VolumeResources& volume, int component)
{
  const std::vector<MaterialTable>& tables = volume.MaterialTables();
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
  const Frame& frame, const VolumeResources& volume, const PacketScene& scene)
{
  std::vector<PacketScene> constituents;
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    const int component = OpacityComponentOf(frame.settings, part);
    PacketScene one = scene;
    one.volume.voxels = volume.PacketVoxels(component)->GetVoidPointer(0);
    if (frame.settings.functionOf == FunctionOf::Value)
    {
      one.look =
        LookOf(frame, volume, scene.parameters, OpacityTableOf(volume, component), component);
    }
    one.colors = ColorsOf(frame, volume, scene.parameters);
    one.spacing = SpacingOf(volume.SpacingBins());
    one.constituent.isOfMixture = true;
    one.constituent.component = part;
    one.constituent.isOfSameBricks = part > 0;
    constituents.push_back(one);
  }
  return constituents;
}

}
