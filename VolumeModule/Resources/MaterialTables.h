#ifndef Varimarch_Resources_MaterialTables_h
#define Varimarch_Resources_MaterialTables_h

#include "Core/Look/OpticalTable.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/VoxelInput.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// A transfer function of two values: colours, and opacities over a unit distance.
struct TwoValueTable
{
  glm::ivec2 size;                ///< The number of entries along each axis, at least two.
  std::vector<glm::vec4> entries; ///< Colours and opacities, x fastest.
};

/// @throws std::runtime_error if there is none, or one without four components for each point
TwoValueTable TwoValueTableOf(vtkImageData* image);

/// A table with the largest extinction of each first value over all second values. It is visible
/// wherever the table of two values is.
OpticalTable UpperBound(
  const TwoValueTable& table, const std::array<double, 2>& range, double opacityUnitDistanceMm);

/// The component that determines the opacity of a part.
int OpacityComponentOf(const RenderSettings& settings, int part);

/// The value of full brightness, by VTK's convention for arrays of colours; 255 for floats that
/// exceed 1.
double LargestColorOf(const VoxelComponents& components);

}

#endif
