#include "March/DenseShadows.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/FrameMeasures.h"

namespace varimarch
{

bool DarkensDenseMatter(const VolumeMarch& march, const MaterialResources& materials)
{
  // Steps can be as short as 1/128 of a voxel, and then have an optical depth of a quarter.
  constexpr double MostDepthOfVoxel = 30.0;
  constexpr double MostDepthOfBox = 1.0;
  const bool isInShadows = march.plan.marcher == Marcher::Device && IsInWayOfLights(march.settings);
  const double depth = materials.MostExtinction() * SmallestSpacingMm(march.frame);
  return isInShadows && depth >= (march.settings.nearest ? MostDepthOfBox : MostDepthOfVoxel);
}

bool HasOpaqueMatterInShadow(const Frame& frame)
{
  return IsInWayOfLights(frame.settings) && !frame.settings.nearest &&
    !OpaqueValuesOf(frame).empty();
}

}
