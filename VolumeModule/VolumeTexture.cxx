#include "VolumeTexture.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace varimarch
{

namespace
{

constexpr double LargestTexel16 = 65535.0;

// Integers spread over the 16 bits by a whole factor, so that each voxel's texel is exact and the
// filter has all bits to interpolate in.
TexelMapping NormalizedMapping(double smallest, double largest)
{
  const double factor = std::floor(LargestTexel16 / std::max(largest - smallest, 1.0));
  return { LargestTexel16 / factor, smallest };
}

// Floats scaled by a power of two, which is exact, to about [-1, 1], so that no product of them
// overflows; and shifted only where the range is small against its distance from zero, as in
// doubles around 1e7 that differ by 1.
TexelMapping FloatMapping(double smallest, double largest)
{
  const double range = largest - smallest;
  const double farthest = std::max(std::abs(smallest), std::abs(largest));
  const bool farFromZero = range > 0.0 && farthest > 2.0 * range;
  const double extent = farFromZero ? range : farthest;
  const double scale = extent > 0.0 ? std::exp2(std::ceil(std::log2(extent))) : 1.0;
  return { scale, farFromZero ? smallest : 0.0 };
}

template <class Scalar>
bool IsFinite(Scalar scalar)
{
  if constexpr (std::is_integral<Scalar>::value)
  {
    return true;
  }
  else
  {
    return std::isfinite(scalar);
  }
}

template <class Scalar>
ScalarGrid<Scalar> GridOf(const Scalar* scalars, const ScalarRegion& region)
{
  return ScalarGrid<Scalar>(scalars, region.dimensions).Part(region.voxels);
}

// Slices are converted and uploaded a few at a time: a second copy of the volume is never held.
// What is not finite becomes 0: a filter makes NaN of it even where its weight is 0.
/// @return whether all scalars are finite
template <class Texel, class Scalar>
bool UploadSlices(const ScalarGrid<Scalar>& grid, const TexelMapping& mapping)
{
  constexpr std::size_t texelsAtOnce = std::size_t(1) << 22;
  const glm::ivec3 dimensions = grid.Dimensions();
  const std::size_t sliceTexels = std::size_t(dimensions.x) * dimensions.y;
  const int slicesAtOnce =
    int(std::clamp(texelsAtOnce / sliceTexels, std::size_t(1), std::size_t(dimensions.z)));
  constexpr bool normalized = std::is_integral<Texel>::value;
  const double factor = (normalized ? LargestTexel16 : 1.0) / mapping.scale;
  const double rounding = normalized ? 0.5 : 0.0;

  std::atomic<bool> allFinite = true;
  std::vector<Texel> texels(sliceTexels * slicesAtOnce);
  for (int slice = 0; slice < dimensions.z; slice += slicesAtOnce)
  {
    const int slices = std::min(slicesAtOnce, dimensions.z - slice);
    tbb::parallel_for(tbb::blocked_range<int>(0, slices * dimensions.y),
      [&](const tbb::blocked_range<int>& rows)
      {
        bool rowsAreFinite = true;
        for (int row = rows.begin(); row != rows.end(); ++row)
        {
          const Scalar* const source = grid.Row(row % dimensions.y, slice + row / dimensions.y);
          Texel* const target = texels.data() + std::size_t(row) * dimensions.x;
          for (int x = 0; x < dimensions.x; ++x)
          {
            const bool finite = IsFinite(source[x]);
            target[x] =
              finite ? Texel((double(source[x]) - mapping.offset) * factor + rounding) : Texel(0);
            rowsAreFinite = rowsAreFinite && finite;
          }
        }
        if (!rowsAreFinite)
        {
          allFinite = false;
        }
      });
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, dimensions.x, dimensions.y, slices, GL_RED,
      normalized ? GL_UNSIGNED_SHORT : GL_FLOAT, texels.data());
  }
  return allFinite;
}

}

double TexelMapping::LimitedTexelOf(double scalar) const
{
  constexpr double most = 1e30;
  return std::clamp(this->TexelOf(scalar), -most, most);
}

void AllocateTexture3D(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  glm::ivec3 dimensions, int vtkType, unsigned int internalFormat, const char* what)
{
  const glm::ivec3 allocated(texture->GetWidth(), texture->GetHeight(), texture->GetDepth());
  if (texture->GetHandle() && allocated == dimensions &&
    texture->GetInternalFormat(vtkType, 1, false) == internalFormat)
  {
    return;
  }
  const auto fail = [&](const std::string& limit)
  {
    std::ostringstream message;
    message << "Cannot draw " << what << " of " << dimensions.x << " x " << dimensions.y << " x "
            << dimensions.z << ": " << limit;
    throw std::runtime_error(message.str());
  };

  const int longestSide = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (std::max({ dimensions.x, dimensions.y, dimensions.z }) > longestSide)
  {
    fail("this device's 3D textures have at most " + std::to_string(longestSide) + " on a side");
  }
  texture->ReleaseGraphicsResources(window);
  texture->ResetFormatAndType();
  texture->SetContext(window);
  texture->SetInternalFormat(internalFormat);
  texture->SetFormat(GL_RED);
  const bool fits =
    texture->AllocateProxyTexture3D(dimensions.x, dimensions.y, dimensions.z, 1, vtkType) &&
    texture->Create3DFromRaw(dimensions.x, dimensions.y, dimensions.z, 1, vtkType, nullptr);
  if (!fits)
  {
    texture->ReleaseGraphicsResources(window);
    fail("the device has not enough memory for one texture of that size");
  }
}

ScalarTexels ScalarTexelsOf(vtkDataArray* scalars)
{
  double range[2];
  scalars->GetFiniteRange(range, 0);
  const bool anyFinite = range[0] <= range[1];
  const int type = scalars->GetDataType();
  ScalarTexels texels;
  texels.smallestScalar = anyFinite ? range[0] : 0.0;
  texels.largestScalar = anyFinite ? range[1] : 0.0;
  texels.integers = type != VTK_FLOAT && type != VTK_DOUBLE;
  texels.normalized =
    texels.integers && texels.largestScalar - texels.smallestScalar <= LargestTexel16;
  texels.mapping = texels.normalized
    ? NormalizedMapping(texels.smallestScalar, texels.largestScalar)
    : FloatMapping(texels.smallestScalar, texels.largestScalar);
  return texels;
}

void VolumeTexture::Upload(
  vtkOpenGLRenderWindow* window, const ScalarRegion& region, const ScalarTexels& texels)
{
  const bool normalized = texels.normalized;
  const glm::ivec3 size = region.voxels.count;
  AllocateTexture3D(this->texture, window, size, normalized ? VTK_UNSIGNED_SHORT : VTK_FLOAT,
    normalized ? GL_R16 : GL_R32F, "a volume");
  this->bytes = std::size_t(size.x) * size.y * size.z * texels.BytesPerTexel();

  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  void* const voxels = region.scalars->GetVoidPointer(0);
  switch (region.scalars->GetDataType())
  {
    vtkTemplateMacro(this->allFinite = normalized
        ? UploadSlices<std::uint16_t>(GridOf(static_cast<VTK_TT*>(voxels), region), texels.mapping)
        : UploadSlices<float>(GridOf(static_cast<VTK_TT*>(voxels), region), texels.mapping));
  }
  this->texture->Deactivate();
}

void VolumeTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
