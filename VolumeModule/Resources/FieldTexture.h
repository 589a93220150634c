#ifndef Varimarch_Resources_FieldTexture_h
#define Varimarch_Resources_FieldTexture_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Fields/ExtremeBricks.h"
#include "Core/Fields/OpticalField.h"
#include "Core/Fields/VisibleBricks.h"
#include "Core/Geometry/UnevenAxis.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/Fingerprint.h"
#include "Resources/VolumeTexture.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <list>
#include <memory>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The ranges of bricks of the components that were drawn last, so that the times of a scan that is
/// played again and again are read once. It keeps no voxels, and at most MostBytes of ranges, or a
/// 32nd of the memory that the program may use.
class KnownRanges
{
public:
  static constexpr std::size_t MostBytes = std::size_t(128) << 20;

  /// @param key  everything that the ranges depend on
  /// @return null if they are not known
  std::shared_ptr<const BrickRanges> Find(const Fingerprint& key);
  /// @param hostBytes  memory that the program may use; 0: no limit
  void Add(const Fingerprint& key, const std::shared_ptr<const BrickRanges>& ranges,
    std::size_t hostBytes);
  void Clear() { this->entries.clear(); }

private:
  struct Entry
  {
    Fingerprint key;
    std::shared_ptr<const BrickRanges> ranges;
  };

  std::list<Entry> entries; ///< The entry that was used last is the first.
};

/// A component, and the optical table of its transfer function.
struct ComponentTable
{
  int component;
  const OpticalTable* table;
  std::uint16_t row; ///< See OpticalChannel.
};

/// A choice of a field that depends on the voxels alone.
struct ValueField
{
  Acceleration kind; ///< CellField or VariationField.
  double tolerance;  ///< See BuildCellField and BuildVariationField.

  bool operator==(const ValueField& other) const
  {
    return this->kind == other.kind && this->tolerance == other.tolerance;
  }
};

/// The field by which rays skip samples, as a 3D texture with one texel for each voxel (variation
/// field), each cell (cell field) or each brick of cells (optical field, extremes).
class AccelerationField
{
public:
  /// Builds a field of the values of a region, which has one component.
  /// @param reachVoxels  see VoxelValues; 0 for a variation field
  /// @throws std::runtime_error if the device cannot hold the texture
  void BuildValueField(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
    const ValueField& chosen, int reachVoxels);

  /// Uploads the texels of a field that is built elsewhere, x fastest.
  /// @throws std::runtime_error if the device cannot hold the texture
  void SetTexels(
    vtkOpenGLRenderWindow* window, glm::ivec3 size, const std::vector<std::uint8_t>& texels);

  /// Builds the part of the optical field that depends only on the voxels: the ranges of bricks. It
  /// is reused by every later BuildOpticalField.
  /// @param voxels     the input of the values
  /// @param hostBytes  see KnownRanges
  /// @return false if the ranges were known since the volume was drawn before
  bool BuildRanges(const VoxelValues& values, const VoxelInput& voxels, std::size_t hostBytes);

  /// Builds the optical field, which stays empty if rays could skip hardly anything.
  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param tables   the optical tables of the components
  /// @param rows     the rows of the volume's mask
  /// @param towards  the ray directions it is for, see DirectionsOf
  /// @param marcher  the marcher that reads it: a texture for the device, Bricks() for the
  /// processor
  void BuildOpticalField(vtkOpenGLRenderWindow* window, const std::vector<ComponentTable>& tables,
    const BrickRows& rows, const OpticalTolerance& tolerance, glm::ivec3 towards, Marcher marcher);

  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param marcher  see BuildOpticalField
  void BuildIsosurfaceField(vtkOpenGLRenderWindow* window, const std::vector<double>& isovalues,
    glm::ivec3 towards, Marcher marcher);

  /// Builds a field of extremes: 16 bit texels with the value at which a ray may skip each brick,
  /// see BuildExtremeBricks.
  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param marcher  the marcher that reads it: a texture for the device, Extremes() for the
  /// processor
  void BuildExtremes(
    vtkOpenGLRenderWindow* window, const ExtremeLook& look, bool largest, Marcher marcher);

  const BrickRanges& Ranges() const { return *this->ranges.front(); } ///< The first component's.
  /// The cells along each side of a brick.
  int CellsPerBrick() const
  {
    return this->ranges.empty() ? BrickRanges::CellsPerSide : this->Ranges().Side();
  }
  vtkTextureObject* Texture() const { return this->texture; }
  const std::vector<std::uint8_t>& Bricks() const { return this->bricks; }
  const std::vector<std::uint16_t>& Extremes() const { return this->extremes; }
  const varimarch::ExtremeBlocks& ExtremeBlocks() const { return this->extremeBlocks; }
  /// The depths between which something may be visible in a view, for the processor. They are valid
  /// until the next call.
  PacketDepths VisibleDepthsIn(const glm::dmat4& clipFromGrid, const glm::vec3& directionGrid,
    glm::ivec2 picturePixels, const Viewport& pixels)
  {
    return this->visibleDepths.Draw(
      this->visibleBlocks, clipFromGrid, directionGrid, picturePixels, pixels);
  }
  bool SkipsAny() const { return this->bytes > 0 || !this->bricks.empty(); }
  /// The smallest box around the visible bricks of the optical field in a part of the volume.
  Box VisibleBoxGrid(const Box& partGrid) const { return this->visible.Bounds(partGrid); }
  glm::ivec3 Size() const { return this->size; } ///< The number of texels along each axis.
  /// The time that the last field took to build, including the ranges built for it [s].
  double BuildSeconds() const { return this->buildSeconds; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  void ReleaseField(vtkWindow* window);
  void SetVisible(const OpticalField& field, Marcher marcher);
  void SetBricks(vtkOpenGLRenderWindow* window, OpticalField field, Marcher marcher);
  void AddBuildSeconds(double seconds);
  template <class Texel>
  void Upload(vtkOpenGLRenderWindow* window, glm::ivec3 size, const std::vector<Texel>& texels);

  vtkNew<vtkTextureObject> texture;
  std::vector<std::shared_ptr<const BrickRanges>>
    ranges; ///< The ranges of bricks of each component.
  KnownRanges knownRanges;
  VisibleBricks visible;
  // Data for the processor: an optical field with the hull of its visible bricks, or a field of
  // extremes.
  std::vector<std::uint8_t> bricks;
  VisibleBlocks visibleBlocks;
  VisibleDepths visibleDepths;
  std::vector<std::uint16_t> extremes;
  varimarch::ExtremeBlocks extremeBlocks;
  glm::ivec3 size = glm::ivec3(1);
  double rangeSeconds = 0.0; ///< The build time of ranges that no field has used yet [s].
  double buildSeconds = 0.0;
  std::size_t bytes = 0;
};

}

#endif
