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

/// A channel, and the transfer function that shows it.
struct ChannelTable
{
  int channel;
  const OpticalTable* table;
};

/// The field that lets rays jump, as a 3D texture of bytes: one for each cell (the scalar field)
/// or for each brick of cells (the optical field).
class AccelerationField
{
public:
  /// Of the cells of a region.
  /// @param tolerance    see BuildVariationField
  /// @param reachVoxels  see VoxelValues
  /// @throws std::runtime_error when the device cannot hold the texture
  void BuildScalarField(
    vtkOpenGLRenderWindow* window, const ScalarRegion& region, double tolerance, int reachVoxels);

  /// What is left out, which only looks like an acceleration.
  /// @throws std::runtime_error when the device cannot hold the texture
  void SetGaps(vtkOpenGLRenderWindow* window, const GapField& gaps);

  /// The part of the optical field that reads the volume; kept for every later BuildOpticalField.
  /// @param axes  of a rectilinear grid; else none
  void BuildRanges(const VoxelValues& values, const std::vector<UnevenAxis>& axes);

  /// There is nothing of it where rays could hardly skip anything.
  /// @throws std::runtime_error when the device cannot hold the texture
  /// @param tables   what shows a channel's values
  /// @param towards  what rays it is for, see DirectionsOf
  /// @param marcher  who reads it: for the processor there is no texture, but Bricks()
  void BuildOpticalField(vtkOpenGLRenderWindow* window, const std::vector<ChannelTable>& tables,
    const OpticalTolerance& tolerance, glm::ivec3 towards, Marcher marcher);

  /// @throws std::runtime_error when the device cannot hold the texture
  /// @param marcher  likewise
  void BuildIsosurfaceField(vtkOpenGLRenderWindow* window, const std::vector<double>& isovalues,
    glm::ivec3 towards, Marcher marcher);

  /// What a ray must have found to leave each brick out, as texels of 16 bits; see
  /// BuildExtremeBricks.
  /// @throws std::runtime_error when the device cannot hold the texture
  /// @param marcher  who reads them: for the processor there is no texture, but Extremes()
  void BuildExtremes(
    vtkOpenGLRenderWindow* window, const ExtremeLook& look, bool largest, Marcher marcher);

  const BrickRanges& Ranges() const { return this->ranges.front(); } ///< of the first channel
  vtkTextureObject* Texture() const { return this->texture; }
  const std::vector<std::uint8_t>& Bricks() const { return this->bricks; }
  const std::vector<std::uint16_t>& Extremes() const { return this->extremes; }
  const varimarch::ExtremeBlocks& ExtremeBlocks() const { return this->extremeBlocks; }
  /// Where the processor marches rays: where along the view of a picture something may be visible,
  /// until the next is asked for.
  PacketDepths VisibleDepthsIn(const glm::dmat4& clipFromGrid, const glm::vec3& directionGrid,
    glm::ivec2 picturePixels, const Viewport& pixels)
  {
    return this->visibleDepths.Draw(
      this->visibleBlocks, clipFromGrid, directionGrid, picturePixels, pixels);
  }
  bool SkipsAny() const { return this->bytes > 0 || !this->bricks.empty(); }
  /// Of the optical field, the smallest box that holds what is visible in a part of the volume.
  Box VisibleBoxGrid(const Box& partGrid) const { return this->visible.Bounds(partGrid); }
  glm::ivec3 Size() const { return this->size; } ///< texels
  /// Of the last field, with the ranges that were built for it.
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
  std::vector<BrickRanges> ranges; ///< of each channel
  VisibleBricks visible;
  // Where the processor marches rays: of an optical field, and the hull of what is visible; or of
  // extremes.
  std::vector<std::uint8_t> bricks;
  VisibleBlocks visibleBlocks;
  VisibleDepths visibleDepths;
  std::vector<std::uint16_t> extremes;
  varimarch::ExtremeBlocks extremeBlocks;
  glm::ivec3 size = glm::ivec3(1);
  double rangeSeconds = 0.0; ///< of ranges that no field has been built of yet
  double buildSeconds = 0.0;
  std::size_t bytes = 0;
};

}

#endif
