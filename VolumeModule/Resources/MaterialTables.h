#ifndef Varimarch_Resources_MaterialTables_h
#define Varimarch_Resources_MaterialTables_h

#include "Core/Look/OpticalTable.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/Fingerprint.h"
#include "Frame/VoxelInput.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

class vtkVolumeProperty;

namespace varimarch
{

/// A transfer function, and the component that it is applied to.
struct MaterialTable
{
  int component;
  TransferFunction transferFunction;
  bool decidesOnOpacity; ///< False if it has colours only.
};

/// The transfer functions of a property's materials: one for each independent component; for two
/// dependent components one of colours, then one of opacities; for RGBA one of opacities; for
/// labels one for each row. One that shows nothing stands for a transfer function of two values.
std::vector<MaterialTable> MaterialTablesOf(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// A transfer function of two values: colours, and opacities over a unit distance.
struct TwoValueTable
{
  glm::ivec2 size;                ///< The number of entries along each axis, at least two.
  std::vector<glm::vec4> entries; ///< Colours and opacities, x fastest.
};

/// @throws std::runtime_error if the property has none
TwoValueTable TwoValueTableOf(vtkVolumeProperty* property);

/// A table with the largest extinction of each first value over all second values. It is visible
/// wherever the table of two values is.
OpticalTable UpperBound(
  const TwoValueTable& table, const std::array<double, 2>& range, double opacityUnitDistanceMm);

/// Everything that these tables depend on, except the range of the values.
Fingerprint MaterialTableInputs(vtkVolumeProperty* property, const RenderSettings& settings);

/// The component that determines the opacity of a part.
int OpacityComponentOf(const RenderSettings& settings, int part);

/// The value of full brightness, by VTK's convention for arrays of colours; 255 for floats that
/// exceed 1.
double LargestColorOf(const VoxelComponents& components);

}

#endif
