#ifndef Varimarch_Resources_MaterialTables_h
#define Varimarch_Resources_MaterialTables_h

#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/RenderSettings.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

class vtkDataArray;
class vtkVolumeProperty;

namespace varimarch
{

/// A transfer function, and the channel of the voxels whose values it shows.
struct MaterialTable
{
  int channel;
  TransferFunction transferFunction;
  bool decidesOnOpacity; ///< of its colours alone nothing is seen
};

/// All that a property's materials are looked up in: of independent components one for each, of
/// two that depend on each other first that of colours, of RGBA only that of opacities, of labels
/// one for each row. Not where transfer functions are of two values.
std::vector<MaterialTable> MaterialTablesOf(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// The labels that have curves of their own. Row i + 1 of the tables is that of the i-th of them,
/// row 0 that of all other labels.
std::vector<int> LabelsOf(vtkVolumeProperty* property);

/// A transfer function of two values: colours, and opacities over a unit distance.
struct TwoValueTable
{
  glm::ivec2 size;                ///< at least two along each axis
  std::vector<glm::vec4> entries; ///< x fastest
};

/// @throws std::runtime_error when the property has none
TwoValueTable TwoValueTableOf(vtkVolumeProperty* property);

/// What shows wherever a table shows anything, whatever its second value is: of each first value
/// the largest extinction.
OpticalTable UpperBound(
  const TwoValueTable& table, const std::array<double, 2>& range, double opacityUnitDistanceMm);

/// All that these tables depend on, but the range of the values.
std::vector<double> MaterialTableInputs(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// The component that a part's opacity is of.
int OpacityComponentOf(const RenderSettings& settings, int part);

/// What a part's extinction is multiplied by in the mixture of all.
double WeightOf(vtkVolumeProperty* property, const RenderSettings& settings, int part);

/// The number that is the brightest colour, as VTK takes numbers that are colours.
double LargestColorOf(vtkDataArray* array);

/// Coefficients of ambient, diffuse and specular light, and the specular power.
glm::dvec4 ReflectanceOf(vtkVolumeProperty* property, int component);

}

#endif
