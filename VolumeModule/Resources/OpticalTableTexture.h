#ifndef Varimarch_Resources_OpticalTableTexture_h
#define Varimarch_Resources_OpticalTableTexture_h

#include "Core/Look/OpticalTable.h"
#include "Resources/FloatBufferTexture.h"
#include "Resources/VolumeTexture.h"

namespace varimarch
{

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

}

#endif
