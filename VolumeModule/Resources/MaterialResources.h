#ifndef Varimarch_Resources_MaterialResources_h
#define Varimarch_Resources_MaterialResources_h

#include "Frame/MarchPlan.h"
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

/// The look of a volume's values: its transfer functions as tables, and the lights. A table is
/// rebuilt when its source has changed, and released when a frame does not need it.
class MaterialResources
{
public:
  /// Updates everything except the pre-integrated table.
  /// @param texels  the texel format of each component, whose range the tables span
  void Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);

  /// Makes or releases the pre-integrated table, depending on the integration rule of the march.
  void UpdatePreIntegrated(const VolumeMarch& march);

  int TableBuilds() const { return this->tableBuilds; } ///< The number of builds so far.
  /// The graphics memory of everything except the pre-integrated table, whose size is known in
  /// advance.
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

  const OpticalTableTexture& OpticalTables() const { return this->opticalTable; }
  const PreIntegratedTableTexture& PreIntegrated() const { return this->preIntegratedTable; }
  const std::vector<MaterialTable>& MaterialTables() const { return this->materialTables; }
  glm::ivec2 TwoValuesSize() const { return this->twoValuesSize; }
  /// The textures of the look, and no others.
  VolumeTextures Textures() const;
  double LastGradient(std::size_t part) const { return this->gradientOpacity.LastGradient(part); }
  double MostExtinction() const; ///< The largest extinction of all functions [1/mm].
  bool MissesCurve() const;      ///< True if a table misses a curve of its function.
  /// True if texels on the device do not tell apart the values that matter to a sum or mean.
  bool MergesValues() const { return this->mergesValues; }

private:
  void UpdateOpticalTable(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);
  std::vector<OpticalTable> BuildTables(
    const VolumeMarch& march, const std::vector<ScalarTexels>& texels);
  /// Sets the function of two values, and returns the largest extinction of each first value.
  OpticalTable BuildTwoValues(const VolumeMarch& march, const ScalarTexels& texels);
  void UpdateLights(const VolumeMarch& march);
  void UpdateIsosurfaces(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);

  OpticalTableTexture opticalTable;
  std::vector<MaterialTable> materialTables; ///< The functions in the optical table.
  int tableBuilds = 0;
  vtkVolumeProperty* tableOfProperty = nullptr;
  std::vector<ScalarTexels> tableOfTexels;
  Fingerprint tableInputs;
  bool mergesValues = false;

  PreIntegratedTableTexture preIntegratedTable;
  int preIntegratedOfTable = 0;      ///< The build number of the optical table it was made from.
  bool preIntegratedIsSmall = false; ///< True if it is the one of a trial.

  FloatTable twoValues; ///< The transfer function of two values.
  glm::ivec2 twoValuesSize = glm::ivec2(1);
  GradientOpacityTable gradientOpacity;
  FloatTable lights; ///< The lights that are no head lights.
  FloatTable isosurfaces;
};

}

#endif
