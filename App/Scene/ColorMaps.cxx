#include "Scene/ColorMaps.h"

#include <array>
#include <utility>

namespace varimarch
{

namespace
{

// Position, red, green and blue, each from 0 to 255.
using Node = std::array<int, 4>;

ColorMap MapOf(const char* name, const std::vector<Node>& nodes)
{
  ColorMap map{ name, {} };
  for (const Node& node : nodes)
  {
    map.nodes.push_back({ node[0] / 255.0, { node[1] / 255.0, node[2] / 255.0, node[3] / 255.0 } });
  }
  return map;
}

std::pair<double, double> ValuesOf(const Look& look, double smallest, double largest)
{
  const double first = look.opacities.front().value;
  const double last = look.opacities.back().value;
  return first < last ? std::pair(first, last) : std::pair(smallest, largest);
}

}

const std::vector<ColorMap>& ColorMaps()
{
  static const std::vector<ColorMap> maps = {
    MapOf("viridis",
      { { 0, 68, 1, 84 }, { 30, 71, 42, 122 }, { 58, 62, 76, 138 }, { 125, 33, 142, 141 },
        { 153, 34, 168, 132 }, { 174, 59, 187, 117 }, { 193, 96, 202, 96 }, { 240, 216, 226, 25 },
        { 246, 231, 228, 25 }, { 255, 253, 231, 37 } }),
    MapOf("cividis",
      { { 0, 0, 34, 78 }, { 22, 0, 49, 113 }, { 35, 32, 58, 111 }, { 53, 56, 71, 108 },
        { 152, 147, 142, 120 }, { 203, 199, 183, 103 }, { 234, 233, 211, 78 },
        { 251, 253, 227, 52 }, { 255, 254, 232, 56 } }),
    MapOf("inferno",
      { { 0, 0, 0, 4 }, { 19, 14, 9, 43 }, { 40, 47, 10, 91 }, { 51, 66, 10, 104 },
        { 64, 87, 16, 110 }, { 105, 152, 39, 102 }, { 146, 212, 72, 66 }, { 172, 239, 108, 35 },
        { 194, 250, 146, 7 }, { 201, 252, 159, 7 }, { 209, 252, 174, 18 }, { 225, 248, 205, 55 },
        { 244, 241, 241, 121 }, { 255, 252, 255, 164 } }),
    MapOf("plasma",
      { { 0, 13, 8, 135 }, { 9, 36, 6, 145 }, { 31, 75, 3, 161 }, { 65, 128, 4, 168 },
        { 91, 163, 30, 154 }, { 138, 213, 83, 111 }, { 173, 239, 124, 81 }, { 202, 252, 163, 56 },
        { 224, 253, 197, 39 }, { 251, 242, 242, 39 }, { 255, 240, 249, 33 } }),
    MapOf("grey", { { 0, 0, 0, 0 }, { 255, 255, 255, 255 } }),
  };
  return maps;
}

Look WithColorMap(const Look& look, const ColorMap& map, double smallest, double largest)
{
  const auto [first, last] = ValuesOf(look, smallest, largest);
  Look colored = look;
  colored.colors = map.nodes;
  for (ColorNode& node : colored.colors)
  {
    node.value = first + node.value * (last - first);
  }
  const TransferFunction function(colored.colors, {}, 1.0);
  for (Isosurface& surface : colored.isosurfaces)
  {
    surface.rgb = function.Color(surface.value);
  }
  return colored;
}

}
