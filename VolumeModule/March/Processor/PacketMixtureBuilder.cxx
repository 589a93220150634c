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
PacketColors ColorsOf(const Frame& frame, const VolumeResources& volume)
{
  PacketColors colors = {};
  if (frame.settings.components == Components::LuminanceOpacity)
  {
    colors.count = 1;
    colors.look = LookOf(frame, volume, 0);
  }
  else if (frame.settings.components == Components::Rgba)
  {
    colors.count = 3;
    colors.colorPerValue = float(1.0 / LargestColorOf(frame.channels.front().array));
  }
  for (int channel = 0; channel < colors.count; ++channel)
  {
    colors.voxels[channel] = volume.PacketVoxels(channel)->GetVoidPointer(0);
  }
  return colors;
}

PacketSpacing SpacingOf(const UnevenBins& uneven)
{
  if (uneven.bins.empty())
  {
    return {};
  }
  return { uneven.bins.data(), uneven.first, uneven.last, uneven.lowerGrid, uneven.binsPerGrid };
}

// The table of a part's opacities.
std::size_t OpacityTableOf(const VolumeResources& volume, int channel)
{
  const std::vector<MaterialTable>& tables = volume.MaterialTables();
  const auto decides = [&](const MaterialTable& table)
  { return table.decidesOnOpacity && table.channel == channel; };
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
    const int channel = OpacityComponentOf(frame.settings, part);
    PacketScene one = scene;
    one.volume.voxels = volume.PacketVoxels(channel)->GetVoidPointer(0);
    if (frame.settings.functionOf == FunctionOf::Value)
    {
      one.look = LookOf(frame, volume, OpacityTableOf(volume, channel));
    }
    one.colors = ColorsOf(frame, volume);
    one.spacing = SpacingOf(volume.SpacingBins());
    one.light.reflectance = ReflectanceOf(frame.property, part);
    one.gradientOpacity = GradientOpacityOf(frame, volume, part);
    one.constituent.isOfMixture = true;
    one.constituent.weight = float(WeightOf(frame.property, frame.settings, part));
    one.constituent.isOfSameBricks = part > 0;
    constituents.push_back(one);
  }
  return constituents;
}

}
