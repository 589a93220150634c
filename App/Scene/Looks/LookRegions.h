#ifndef Varimarch_Scene_LookRegions_h
#define Varimarch_Scene_LookRegions_h

#include "Scene/Model/Scene.h"

#include <glm/vec4.hpp>

#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace varimarch
{

// Two-dimensional transfer functions: regions of the plane of value and gradient magnitude.

/// The largest number of regions in a look.
constexpr std::size_t MostRegions = 64;

/// Position of a point of the plane in a region: 0 in its middle and 1 at its edge. A rectangle
/// that begins at the gradient 0 has no edge there.
double PlaceInRegion(const LookRegion& region, double value, double gradient);

/// The colour of a point of the plane, and its opacity over the unit distance. Later regions lie
/// over earlier ones. A point outside of all has the colour of the nearest and the opacity 0.
/// @param regions  at least one
glm::dvec4 ColorInRegions(const std::vector<LookRegion>& regions, double value, double gradient);

/// The regions for values that are multiplied by a factor > 0 and shifted by an offset.
std::vector<LookRegion> TransformedRegions(
  std::vector<LookRegion> regions, double factor, double offset);

/// The largest gradient magnitude that mappers tell from larger ones, in the volume's first
/// component: a quarter of its range per mean voxel spacing [units of the data per mm].
double LargestRegionGradient(vtkImageData* image);

/// Makes a property draw regions, whose values are in units of the data, as a table of 512 values
/// and 128 gradients.
/// @param regions  at least one
void ApplyRegions(
  const std::vector<LookRegion>& regions, vtkImageData* image, vtkVolumeProperty* property);

}

#endif
