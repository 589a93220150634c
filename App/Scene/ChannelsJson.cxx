#include "Scene/ChannelsJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

LookChannel ChannelFromJson(const JsonCursor& json)
{
  json.RequireObject({ "name", "rgb", "visible", "opacity", "window" });
  LookChannel channel;
  if (const auto name = json.Find("name"))
  {
    channel.name = name->Text();
  }
  if (const auto color = json.Find("rgb"))
  {
    const std::array<double, 3> rgb = color->Numbers<3>(UnitInterval);
    channel.rgb = { rgb[0], rgb[1], rgb[2] };
  }
  if (const auto visible = json.Find("visible"))
  {
    channel.visible = visible->Boolean();
  }
  if (const auto opacity = json.Find("opacity"))
  {
    channel.opacity = opacity->Number(UnitInterval);
  }
  if (const auto window = json.Find("window"))
  {
    channel.window = window->Numbers<2>();
    if (!((*channel.window)[0] < (*channel.window)[1]))
    {
      window->Fail("expected the smaller value first, found the larger one or two equal ones");
    }
  }
  return channel;
}

}

std::vector<LookChannel> ChannelsFromJson(const JsonCursor& json)
{
  std::vector<LookChannel> channels;
  for (const JsonCursor& element : json.Elements(1, MostChannels))
  {
    channels.push_back(ChannelFromJson(element));
  }
  return channels;
}

nlohmann::ordered_json JsonFromChannels(const std::vector<LookChannel>& channels)
{
  nlohmann::ordered_json json;
  for (const LookChannel& channel : channels)
  {
    nlohmann::ordered_json one = { { "name", channel.name } };
    if (channel.rgb)
    {
      one["rgb"] = { channel.rgb->r, channel.rgb->g, channel.rgb->b };
    }
    one["visible"] = channel.visible;
    one["opacity"] = channel.opacity;
    if (channel.window)
    {
      one["window"] = *channel.window;
    }
    json.push_back(one);
  }
  return json;
}

}
