#ifndef Varimarch_Resources_MaterialResources_h
#define Varimarch_Resources_MaterialResources_h

#include "Core/Look/OpticalTable.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Frame/MarchPlan.h"
#include "Resources/FloatTable.h"
#include "Resources/MaterialTables.h"
#include "Resources/VolumeTexture.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
namespace varimarch
{

/// The gradient opacity curves, one for each material of a mixture or each row of labels. Each
/// entry of the table has the values of four curves. Empty unless the settings have gradient
/// opacity.
class GradientOpacityTable
{
public:
  /// Entries per curve. With this many, the error for a piecewise linear function is too small for
  /// a display.
  static constexpr int EntriesPerCurve = 4096;

  /// Makes the table if a curve, or the range of the gradients, has changed.
  /// @param texels  the texel format of each component of the volume
  void Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);

  MarchTexture Texture() const { return this->table.Texture(); }
  /// The gradient of the last entry of a part's curve.
  double LastGradient(std::size_t part) const { return this->lastGradients[part]; }
  std::size_t Bytes() const { return this->table.Bytes(); }
  void Release(vtkWindow* window);

private:
  FloatTable table;
  std::vector<double> lastGradients;
  Fingerprint source; ///< The inputs of the table; empty if there is none.
};

/// A PreIntegratedTable on the device, or in memory if the processor marches.
class PreIntegratedTableTexture
{
public:
  void Upload(vtkOpenGLRenderWindow* window, PreIntegratedTable table);
  void Keep(vtkWindow* window, PreIntegratedTable table);

  bool IsKept() const { return !this->kept.entries.empty(); }
  const PreIntegratedTable& Kept() const { return this->kept; }
  vtkTextureObject* Texture() const { return this->texture; }
  int EntriesPerSide() const { return this->IsKept() ? this->kept.size : this->size; }
  std::size_t Bytes() const { return std::size_t(this->size) * this->size * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  int size = 0; ///< The number of texels on a side.
  PreIntegratedTable kept = {};
};

/// Transfer functions as OpticalTables in memory and, for shaders, one after the other in a
/// texture.
class OpticalTableTexture
{
public:
  /// @param tables  at least one
  void SetTables(vtkWindow* window, std::vector<OpticalTable> tables);

  /// Uploads the tables to the device.
  void Upload(vtkOpenGLRenderWindow* window);
  /// Uploads the tables preceded by an index with a row for each of them, as
  /// Shaders/Classify/LabelTables.glsl reads them.
  /// @param mapping  the mapping of the texels that are looked up
  void UploadRows(vtkOpenGLRenderWindow* window, const TexelMapping& mapping);
  /// Keeps the tables in memory only.
  void ReleaseTexture(vtkWindow* window) { this->texture.Release(window); }

  vtkTextureObject* Texture() const { return this->texture.Texture(); }

  const OpticalTable& Table() const { return this->tables.front(); }
  const std::vector<OpticalTable>& Tables() const { return this->tables; }
  const std::array<double, 2>& VisibleValues(std::size_t table = 0) const
  {
    return this->visibleValues[table];
  }
  std::array<double, 2> VisibleValuesOfAny() const; ///< The range of values visible in any table.
  std::size_t FirstEntryOf(
    std::size_t table) const; ///< The index of its first entry in the buffer.
  std::size_t Bytes() const { return this->texture.Bytes(); }
  void Release(vtkWindow* window);

private:
  void UploadBehind(vtkOpenGLRenderWindow* window, std::vector<glm::vec4> rows);

  FloatBufferTexture texture;
  std::vector<OpticalTable> tables = { OpticalTable() };
  std::vector<std::array<double, 2>> visibleValues; ///< The range of visible values of each table.
};

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
  const std::vector<MaterialFunction>& MaterialTables() const { return this->materialTables; }
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
  std::vector<MaterialFunction> materialTables; ///< The functions in the optical table.
  int tableBuilds = 0;
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
