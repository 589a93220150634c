#include "Scene/LookChannels.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Green and magenta, with what overlaps in white, are told apart with any kind of colour vision.
const std::array<glm::dvec3, MostChannels> UsualColors = { { { 0.2, 1.0, 0.2 }, { 1.0, 0.2, 1.0 },
  { 0.2, 0.8, 1.0 }, { 1.0, 0.8, 0.2 } } };

// Moves the values of all curves so that the opacities reach from end to end of a window.
void Stretch(const std::array<double, 2>& window, Look& look)
{
  const double first = look.opacities.front().value;
  const double width = look.opacities.back().value - first;
  if (!(width > 0.0))
  {
    return;
  }
  const double factor = (window[1] - window[0]) / width;
  const auto move = [&](auto& nodes)
  {
    for (auto& node : nodes)
    {
      node.value = window[0] + factor * (node.value - first);
    }
  };
  move(look.colors);
  move(look.opacities);
  move(look.isosurfaces);
  for (OpacityNode& node : look.gradientOpacities)
  {
    node.value *= factor;
  }
}

}

std::vector<LookChannel> WithAllChannels(
  std::vector<LookChannel> given, const std::vector<VolumeChannel>& channels)
{
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (i >= given.size())
    {
      given.push_back({ {}, channels[i].rgb.value_or(UsualColors[i % UsualColors.size()]) });
    }
    given[i].name = given[i].name.empty() ? channels[i].name : given[i].name;
  }
  return given;
}

Look LookOfChannel(const Look& look, std::size_t channel)
{
  Look own = look;
  if (channel >= look.channels.size())
  {
    return own;
  }
  const LookChannel& settings = look.channels[channel];
  if (settings.window)
  {
    Stretch(*settings.window, own);
  }
  if (settings.rgb)
  {
    own.colors = { { own.colors.front().value, *settings.rgb } };
  }
  for (OpacityNode& node : own.opacities)
  {
    node.opacity *= settings.visible ? settings.opacity : 0.0;
  }
  return own;
}

}
