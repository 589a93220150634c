#ifndef Varimarch_Scene_ColorMaps_h
#define Varimarch_Scene_ColorMaps_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Colours from dark to light that people with any kind of colour vision read alike.
struct ColorMap
{
  std::string name;
  std::vector<ColorNode> nodes; ///< from 0 to 1
};

/// Viridis, inferno and plasma of S. van der Walt and N. Smith (2015), cividis of J. Nunez,
/// C. Anderton and R. Renslow (PLOS ONE 13(7), 2018), each within 4 of 255, and grey.
const std::vector<ColorMap>& ColorMaps();

/// Gives a look the colours of a map, from the first value of its opacities to the last, and its
/// isosurfaces those at their places among them.
/// @param smallest, largest  of the volume: the ends where the opacities have but one value
Look WithColorMap(const Look& look, const ColorMap& map, double smallest, double largest);

}

#endif
