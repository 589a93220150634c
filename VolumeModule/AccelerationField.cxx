#include "AccelerationField.h"

#include "Core/VariationField.h"
#include "VolumeTexture.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <chrono>
#include <utility>

namespace varimarch
{

namespace
{

VariationField ScalarFieldOf(const ScalarRegion& region, double tolerance)
{
  void* const voxels = region.scalars->GetVoidPointer(0);
  switch (region.scalars->GetDataType())
  {
    vtkTemplateMacro(return BuildVariationField(
      ScalarGrid<VTK_TT>(static_cast<VTK_TT*>(voxels), region.dimensions).Part(region.voxels),
      tolerance));
  }
  return {};
}

BrickRanges RangesOf(vtkDataArray* scalars, glm::ivec3 dimensions, double smallest, double largest)
{
  void* const voxels = scalars->GetVoidPointer(0);
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return BuildBrickRanges(
      ScalarGrid<VTK_TT>(static_cast<VTK_TT*>(voxels), dimensions), smallest, largest));
  }
  return {};
}

class Stopwatch
{
public:
  double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->start).count();
  }

private:
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

}

template <class Texel>
void AccelerationField::Upload(
  vtkOpenGLRenderWindow* window, glm::ivec3 size, const std::vector<Texel>& texels)
{
  constexpr bool narrow = sizeof(Texel) == 1;
  AllocateTexture3D(this->texture, window, size, narrow ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT,
    narrow ? GL_R8 : GL_R16, "an acceleration field");
  this->size = size;
  this->bytes = texels.size() * sizeof(Texel);

  // Nearest: a value between two texels would promise what neither proves.
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size.x, size.y, size.z, GL_RED,
    narrow ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT, texels.data());
  this->texture->Deactivate();
}

void AccelerationField::BuildScalarField(
  vtkOpenGLRenderWindow* window, const ScalarRegion& region, double tolerance)
{
  const Stopwatch stopwatch;
  const VariationField field = ScalarFieldOf(region, tolerance);
  this->buildSeconds = stopwatch.Seconds();
  this->Upload(window, field.cellCount, field.cells);
}

void AccelerationField::BuildRanges(
  vtkDataArray* scalars, glm::ivec3 dimensions, double smallestScalar, double largestScalar)
{
  const Stopwatch stopwatch;
  this->ranges = RangesOf(scalars, dimensions, smallestScalar, largestScalar);
  this->rangeSeconds = stopwatch.Seconds();
}

void AccelerationField::BuildOpticalField(
  vtkOpenGLRenderWindow* window, const OpticalTable& table, const OpticalTolerance& tolerance)
{
  const Stopwatch stopwatch;
  const OpticalField field = varimarch::BuildOpticalField(this->ranges, table, tolerance);
  this->visible = VisibleBricks(field);
  this->buildSeconds = std::exchange(this->rangeSeconds, 0.0) + stopwatch.Seconds();
  this->Upload(window, field.brickCount, field.bricks);
}

void AccelerationField::BuildExtremes(vtkOpenGLRenderWindow* window, bool largest)
{
  const Stopwatch stopwatch;
  const glm::ivec3 count = this->ranges.BrickCount();
  std::vector<std::uint16_t> extremes(std::size_t(count.x) * count.y * count.z);
  for (std::size_t i = 0; i < extremes.size(); ++i)
  {
    const BrickRanges::Steps steps = this->ranges[i];
    // Beside a value that is not finite there may be any other.
    const std::uint16_t unknown = largest ? 65535 : 0;
    const std::uint16_t extreme = largest ? steps.largest : steps.smallest;
    extremes[i] = steps.IsFinite() ? extreme : unknown;
  }
  this->buildSeconds = std::exchange(this->rangeSeconds, 0.0) + stopwatch.Seconds();
  this->Upload(window, count, extremes);
}

void AccelerationField::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->ranges = BrickRanges();
  this->visible = VisibleBricks();
  this->bytes = 0;
}

}
