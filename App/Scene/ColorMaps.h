#ifndef Varimarch_Scene_ColorMaps_h
#define Varimarch_Scene_ColorMaps_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A sequential colour map, from dark to light, readable with any kind of colour vision.
struct ColorMap
{
  std::string name;
  std::vector<ColorNode> nodes; ///< values from 0 to 1
};

/// Viridis, inferno and plasma by S. van der Walt and N. Smith (2015), cividis by J. Nunez, C.
/// Anderton and R. Renslow (PLOS ONE 13(7), 2018), each within 4/255 of the original, and grey.
const std::vector<ColorMap>& ColorMaps();

/// Spreads a colour map over a look, from its first opacity node to its last, and colours its
/// isosurfaces from the same map.
/// @param smallest, largest  value range of the volume, used when all opacity nodes have one value
Look WithColorMap(const Look& look, const ColorMap& map, double smallest, double largest);

}

#endif
