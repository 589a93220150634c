#ifndef Varimarch_Resources_MaterialResources_h
#define Varimarch_Resources_MaterialResources_h

#include "Frame/MarchPlan.h"
#include "Resources/FloatBufferTexture.h"
#include "Resources/FloatTable.h"
#include "Resources/GradientOpacityTable.h"
#include "Resources/MaterialTables.h"
#include "Resources/OpticalTableTexture.h"
#include "Resources/PreIntegratedTableTexture.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class vtkVolumeProperty;

namespace varimarch
{

/// Two entries for each isosurface: its colour and optical depth, and its isovalue.
std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame);

/// The look of a volume's values: its transfer functions as tables, and the lights. A table
/// is made again when its source has changed, and released when a frame does not need it.
class MaterialResources
{
public:
  /// Everything but the pre-integrated table.
  /// @param texels       those of each component
  /// @param volumeBuild  the number of the volume, whose range the tables span
  void Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels, int volumeBuild);

  /// Makes or releases the pre-integrated table, as the integration rule of the march asks for it.
  void UpdatePreIntegrated(const VolumeMarch& march);

  int TableBuilds() const { return this->tableBuilds; } ///< How often the optical table was made.
  /// The graphics memory of everything but the pre-integrated table, whose size is known before.
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

  const OpticalTableTexture& OpticalTables() const { return this->opticalTable; }
  const PreIntegratedTableTexture& PreIntegrated() const { return this->preIntegratedTable; }
  const std::vector<MaterialTable>& MaterialTables() const { return this->materialTables; }
  const FloatTable& TwoValues() const { return this->twoValues; }
  glm::ivec2 TwoValuesSize() const { return this->twoValuesSize; }
  const FloatTable& GradientOpacity() const { return this->gradientOpacity.Table(); }
  const FloatBufferTexture& LightTexels() const { return this->lights; }
  const FloatBufferTexture& Isosurfaces() const { return this->isosurfaces; }

private:
  void UpdateOpticalTable(
    const VolumeMarch& march, const std::vector<ScalarTexels>& texels, int volumeBuild);
  std::vector<OpticalTable> BuildTables(
    const VolumeMarch& march, const std::vector<ScalarTexels>& texels);
  void UpdateLights(const VolumeMarch& march);
  void UpdateIsosurfaces(const VolumeMarch& march, const TexelMapping& mapping);

  OpticalTableTexture opticalTable;
  std::vector<MaterialTable> materialTables; ///< The functions in the optical table.
  int tableBuilds = 0;
  vtkVolumeProperty* tableOfProperty = nullptr;
  int tableOfVolume = 0;
  std::vector<double> tableInputs;

  PreIntegratedTableTexture preIntegratedTable;
  int preIntegratedOfTable = 0; ///< The build of the optical table that it was made from.

  FloatTable twoValues; ///< A transfer function of two values.
  glm::ivec2 twoValuesSize = glm::ivec2(1);
  GradientOpacityTable gradientOpacity;
  FloatBufferTexture lights; ///< On the device only, if there are other lights than head lights.
  FloatBufferTexture isosurfaces;
};

}

#endif
