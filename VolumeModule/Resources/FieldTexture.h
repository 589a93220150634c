#ifndef Varimarch_Resources_FieldTexture_h
#define Varimarch_Resources_FieldTexture_h

#include "Core/Fields/BrickRanges.h"
#include "Core/Fields/ExtremeBricks.h"
#include "Core/Fields/GapField.h"
#include "Core/Fields/OpticalField.h"
#include "Core/Fields/VisibleBricks.h"
#include "Core/Fields/VisibleDepths.h"
#include "Core/Geometry/UnevenAxis.h"
#include "Core/Recipe/RenderSettings.h"
#include "Resources/VolumeTexture.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A component, and the table of the transfer function that shows it.
struct ComponentTable
{
  int component;
  const OpticalTable* table;
};

/// The field that lets rays jump, as a 3D texture of bytes: one for each cell (the scalar field)
/// or for each brick of cells (the optical field).
class AccelerationField
{
public:
  /// Builds the scalar field of the cells of a region.
  /// @param tolerance    see BuildVariationField
  /// @param reachVoxels  see VoxelValues
  /// @throws std::runtime_error if the device cannot hold the texture
  void BuildScalarField(
    vtkOpenGLRenderWindow* window, const ScalarRegion& region, double tolerance, int reachVoxels);

  /// Takes the gaps of a volume, which are stored like a field.
  /// @throws std::runtime_error if the device cannot hold the texture
  void SetGaps(vtkOpenGLRenderWindow* window, const GapField& gaps);

  /// Builds the part of the optical field that reads the volume. It is kept for every later
  /// BuildOpticalField.
  /// @param axes  the axes of a rectilinear grid; none for an image
  void BuildRanges(const VoxelValues& values, const std::vector<UnevenAxis>& axes);

  /// Builds the optical field, which stays empty if rays could hardly skip anything.
  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param tables   the tables that show the values of components
  /// @param towards  the directions of its rays, see DirectionsOf
  /// @param marcher  the reader: for the processor there is no texture, but Bricks()
  void BuildOpticalField(vtkOpenGLRenderWindow* window, const std::vector<ComponentTable>& tables,
    const OpticalTolerance& tolerance, glm::ivec3 towards, Marcher marcher);

  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param marcher  see BuildOpticalField
  void BuildIsosurfaceField(vtkOpenGLRenderWindow* window, const std::vector<double>& isovalues,
    glm::ivec3 towards, Marcher marcher);

  /// Builds a field of extremes: the value that lets a ray leave out each brick, as texels of 16
  /// bits, see BuildExtremeBricks.
  /// @throws std::runtime_error if the device cannot hold the texture
  /// @param marcher  the reader: for the processor there is no texture, but Extremes()
  void BuildExtremes(
    vtkOpenGLRenderWindow* window, const ExtremeLook& look, bool largest, Marcher marcher);

  const BrickRanges& Ranges() const { return this->ranges.front(); } ///< For the first component.
  vtkTextureObject* Texture() const { return this->texture; }
  const std::vector<std::uint8_t>& Bricks() const { return this->bricks; }
  const std::vector<std::uint16_t>& Extremes() const { return this->extremes; }
  const varimarch::ExtremeBlocks& ExtremeBlocks() const { return this->extremeBlocks; }
  /// The depths between which something may be visible along the view, for the processor. They are
  /// valid until the next call.
  PacketDepths VisibleDepthsIn(const glm::dmat4& clipFromGrid, const glm::vec3& directionGrid,
    glm::ivec2 picturePixels, const Viewport& pixels)
  {
    return this->visibleDepths.Draw(
      this->visibleBlocks, clipFromGrid, directionGrid, picturePixels, pixels);
  }
  bool SkipsAny() const { return this->bytes > 0 || !this->bricks.empty(); }
  /// The smallest box around what the optical field has visible in a part of the volume.
  Box VisibleBoxGrid(const Box& partGrid) const { return this->visible.Bounds(partGrid); }
  glm::ivec3 Size() const { return this->size; } ///< The number of texels along each axis.
  /// The time to build the last field and the ranges that it needed [s].
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
  std::vector<BrickRanges> ranges; ///< One for each component.
  VisibleBricks visible;
  // For the processor: an optical field and the hull of what is visible, or a field of extremes.
  std::vector<std::uint8_t> bricks;
  VisibleBlocks visibleBlocks;
  VisibleDepths visibleDepths;
  std::vector<std::uint16_t> extremes;
  varimarch::ExtremeBlocks extremeBlocks;
  glm::ivec3 size = glm::ivec3(1);
  double rangeSeconds = 0.0; ///< The time for ranges that no field has used yet.
  double buildSeconds = 0.0;
  std::size_t bytes = 0;
};

}

#endif
