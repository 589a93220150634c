#ifndef Varimarch_MaterialTables_h
#define Varimarch_MaterialTables_h

#include "Core/RenderSettings.h"
#include "Core/TransferFunction.h"

#include <vector>

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
/// two that depend on each other first that of colours, of RGBA only that of opacities.
std::vector<MaterialTable> MaterialTablesOf(
  vtkVolumeProperty* property, const RenderSettings& settings);

/// All that these tables depend on, but the range of the values.
std::vector<double> MaterialTableInputs(
  vtkVolumeProperty* property, const RenderSettings& settings);

}

#endif
