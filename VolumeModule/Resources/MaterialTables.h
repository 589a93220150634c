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

/// A transfer function, and the component of the voxels whose values it shows.
struct MaterialTable
{
  int component;
  TransferFunction transferFunction;
  bool decidesOnOpacity; ///< False if it has colours only, of which alone nothing is seen.
};

/// The transfer functions that a property's materials are looked up in: one for each independent
/// component; of two dependent components first that of colours; of RGBA only that of opacities; of
/// labels one for each row. Transfer functions of two values have none of these.
std::vector<MaterialTable> MaterialTablesOf(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// A transfer function of two values: colours, and opacities over a unit distance.
struct TwoValueTable
{
  glm::ivec2 size;                ///< At least two along each axis.
  std::vector<glm::vec4> entries; ///< Row by row, x fastest.
};

/// @throws std::runtime_error if the property has none
TwoValueTable TwoValueTableOf(vtkVolumeProperty* property);

/// A table of the largest extinction of each first value. It shows something wherever the table of
/// two values does, whatever the second value is.
OpticalTable UpperBound(
  const TwoValueTable& table, const std::array<double, 2>& range, double opacityUnitDistanceMm);

/// Everything that these tables depend on, except the range of the values.
std::vector<double> MaterialTableInputs(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// The component whose values decide on the opacity of a part.
int OpacityComponentOf(const RenderSettings& settings, int part);

/// The factor of a part's extinction in the mixture of all.
double WeightOf(vtkVolumeProperty* property, const RenderSettings& settings, int part);

/// The number of the brightest colour, by VTK's convention for numbers that are colours.
double LargestColorOf(vtkDataArray* array);

/// Coefficients of ambient, diffuse and specular light, and the specular power.
glm::dvec4 ReflectanceOf(vtkVolumeProperty* property, int component);

}

#endif
