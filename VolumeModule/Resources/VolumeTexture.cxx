#include "Resources/VolumeTexture.h"

#include "Frame/FiniteRange.h"
#include "VtkVersions.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h"
#include "vtkType.h"

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

// Spreads integers over 16 bits by an integer factor, so that each voxel's texel is exact and the
// filter interpolates with all bits.
TexelMapping NormalizedMapping(double smallest, double largest)
{
  const double factor = std::floor(LargestTexel16 / std::max(largest - smallest, 1.0));
  return { LargestTexel16 / factor, smallest };
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

// Rows of voxels, and the mapping of one of their components to texels.
struct ComponentRows
{
  glm::ivec3 dimensions; ///< The size of the volume.
  VoxelRegion voxels;    ///< The rows.
  int texelStride;       ///< The distance between consecutive texels [numbers].
  TexelMapping mapping;
};

/// Converts a row of voxels. A non-finite number becomes 0, because a filter would turn it into NaN
/// even where its weight is 0.
/// @return true if all scalars are finite
template <class Texel, class Scalar>
bool ConvertScalars(const Scalar* source, int stride, Texel* target, int texelStride, int count,
  const TexelMapping& mapping)
{
  constexpr bool normalized = std::is_integral<Texel>::value;
  const double factor = (normalized ? LargestTexel16 : 1.0) / mapping.scale;
  const double rounding = normalized ? 0.5 : 0.0;
  bool allFinite = true;
  for (int x = 0; x < count; ++x)
  {
    const Scalar scalar = source[x * stride];
    const bool finite = IsFinite(scalar);
    const double texel = (double(scalar) - mapping.offset) * factor + rounding;
    target[x * texelStride] = finite
      ? Texel(normalized ? texel : std::clamp(texel, -LargestTexel, LargestTexel))
      : Texel(0);
    allFinite = allFinite && finite;
  }
  return allFinite;
}

// Converts a row of voxels whose type is chosen at run time, so that the loop over rows is compiled
// only once per texel type.
template <class Texel>
using RowConverter = bool (*)(const void* source, int stride, Texel* target, int texelStride,
  int count, const TexelMapping& mapping);

template <class Texel, class Scalar>
bool ConvertRow(const void* source, int stride, Texel* target, int texelStride, int count,
  const TexelMapping& mapping)
{
  const auto* const scalars = static_cast<const Scalar*>(source);
  // Constant strides make the usual cases faster.
  return stride == 1 && texelStride == 1
    ? ConvertScalars(scalars, 1, target, 1, count, mapping)
    : ConvertScalars(scalars, stride, target, texelStride, count, mapping);
}

/// @param vtkType  a numeric type
template <class Texel>
RowConverter<Texel> RowConverterOf(int vtkType)
{
  switch (vtkType)
  {
    vtkTemplateMacro(return (&ConvertRow<Texel, VTK_TT>));
  }
  return nullptr;
}

/// @return true if all scalars are finite
template <class Texel>
bool ConvertComponent(const VoxelComponent& component, const ComponentRows& rows, Texel* texels)
{
  const RowConverter<Texel> convertRow = RowConverterOf<Texel>(component.array->GetDataType());
  const auto* const scalars =
    static_cast<const char*>(component.array->GetVoidPointer(component.index));
  const int stride = component.array->GetNumberOfComponents();
  const std::size_t voxelBytes = std::size_t(stride) * component.array->GetDataTypeSize();
  std::atomic<bool> allFinite = true;
  const glm::ivec3 count = rows.voxels.count;
  const glm::ivec3 first = rows.voxels.first;
  tbb::parallel_for(tbb::blocked_range<int>(0, count.y * count.z),
    [&](const tbb::blocked_range<int>& range)
    {
      bool rowsAreFinite = true;
      for (int row = range.begin(); row != range.end(); ++row)
      {
        const std::size_t y = first.y + row % count.y;
        const std::size_t z = first.z + row / count.y;
        const std::size_t voxel = first.x + rows.dimensions.x * (y + rows.dimensions.y * z);
        Texel* const target = texels + std::size_t(row) * count.x * rows.texelStride;
        const bool finite = convertRow(
          scalars + voxel * voxelBytes, stride, target, rows.texelStride, count.x, rows.mapping);
        rowsAreFinite = rowsAreFinite && finite;
      }
      if (!rowsAreFinite)
      {
        allFinite = false;
      }
    });
  return allFinite;
}

constexpr GLenum FormatOfComponents[] = { GL_RED, GL_RG, GL_RGB, GL_RGBA };
constexpr GLint Format16OfComponents[] = { GL_R16, GL_RG16, GL_RGB16, GL_RGBA16 };
constexpr GLint FormatFloatOfComponents[] = { GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F };

/// Converts and uploads a few slices at a time, so that memory never holds a second copy of the
/// volume.
/// @return true if all scalars are finite
template <class Texel>
bool UploadSlices(const ScalarRegion& region, const std::vector<ScalarTexels>& texelsOfComponents)
{
  constexpr std::size_t texelsAtOnce = std::size_t(1) << 22;
  const VoxelRegion& all = region.voxels;
  const int components = int(region.components.size());
  const std::size_t sliceTexels = std::size_t(all.count.x) * all.count.y * components;
  const int slicesAtOnce =
    int(std::clamp(texelsAtOnce / sliceTexels, std::size_t(1), std::size_t(all.count.z)));
  bool allFinite = true;
  std::vector<Texel> texels(sliceTexels * slicesAtOnce);
  for (int slice = 0; slice < all.count.z; slice += slicesAtOnce)
  {
    const int slices = std::min(slicesAtOnce, all.count.z - slice);
    const VoxelRegion part{ all.first + glm::ivec3(0, 0, slice),
      { all.count.x, all.count.y, slices } };
    for (int i = 0; i < components; ++i)
    {
      const VoxelComponent& component = region.components[i];
      const ComponentRows rows{ region.dimensions, part, components,
        texelsOfComponents[i].mapping };
      allFinite = ConvertComponent(component, rows, texels.data() + i) && allFinite;
    }
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, part.count.x, part.count.y, slices,
      FormatOfComponents[components - 1],
      std::is_integral<Texel>::value ? GL_UNSIGNED_SHORT : GL_FLOAT, texels.data());
  }
  return allFinite;
}

void CheckDifference(const ScalarTexels& texels)
{
  const double difference = texels.largestScalar - texels.smallestScalar;
  if (0.0 < difference && difference < SmallestDifference)
  {
    std::ostringstream message;
    message << "Cannot draw scalars that differ by at most " << difference << ": expected "
            << SmallestDifference << " or more; multiply them by a large number";
    throw std::runtime_error(message.str());
  }
}

GLenum InternalFormatOf(const std::vector<ScalarTexels>& texels)
{
  const std::size_t components = texels.size();
  return texels.front().normalized ? Format16OfComponents[components - 1]
                                   : FormatFloatOfComponents[components - 1];
}

}

// Scales by a power of two, which is exact. Numbers are shifted only if their range is small
// compared with its distance from zero, as for doubles around 1e7 that differ by 1, or if all are
// the same, for floats need not represent that number.
TexelMapping FloatMapping(double smallest, double largest)
{
  const double range = largest - smallest;
  const double farthest = std::max(std::abs(smallest), std::abs(largest));
  const bool farFromZero = farthest > 2.0 * range;
  const double extent = farFromZero && range > 0.0 ? range : farthest;
  const double scale = extent > 0.0 ? std::exp2(std::ceil(std::log2(extent))) : 1.0;
  return { scale, farFromZero ? smallest : 0.0 };
}

double TexelMapping::LimitedTexelOf(double scalar) const
{
  constexpr double most = 1e30;
  return std::clamp(this->TexelOf(scalar), -most, most);
}

void AllocateTexture3D(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  glm::ivec3 dimensions, int vtkType, unsigned int internalFormat, int components, const char* what)
{
  const glm::ivec3 allocated(texture->GetWidth(), texture->GetHeight(), texture->GetDepth());
  if (texture->GetHandle() && allocated == dimensions &&
    texture->GetInternalFormat(vtkType, components, false) == internalFormat)
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
  texture->SetFormat(FormatOfComponents[components - 1]);
  const bool fits = texture->AllocateProxyTexture3D(
                      dimensions.x, dimensions.y, dimensions.z, components, vtkType) &&
    texture->Create3DFromRaw(
      dimensions.x, dimensions.y, dimensions.z, components, vtkType, nullptr);
  if (!fits)
  {
    texture->ReleaseGraphicsResources(window);
    fail("the device has not enough memory for one texture of that size; set a maximum graphics "
         "memory to draw the volume in smaller blocks");
  }
}

std::vector<ScalarTexels> ScalarTexelsOf(const VoxelComponents& components)
{
  std::vector<ScalarTexels> all;
  bool allNormalized = true;
  bool allIntegers = true;
  for (const VoxelComponent& component : components)
  {
    const ValueRange finite = FiniteRangeOf(component);
    const bool anyFinite = !finite.IsEmpty();
    const int type = component.array->GetDataType();
    ScalarTexels texels;
    texels.smallestScalar = anyFinite ? Limited(finite.lower) : 0.0;
    texels.largestScalar = anyFinite ? Limited(finite.upper) : 0.0;
    CheckDifference(texels);
    texels.smallestValue = texels.smallestScalar;
    texels.largestValue = texels.largestScalar;
    texels.gray = { texels.smallestScalar, texels.largestScalar };
    texels.resolved = texels.gray;
    allIntegers = allIntegers && type != VTK_FLOAT && type != VTK_DOUBLE;
    allNormalized = allNormalized && allIntegers &&
      texels.largestScalar - texels.smallestScalar <= LargestTexel16;
    all.push_back(texels);
  }
  for (ScalarTexels& texels : all)
  {
    texels.finite = allIntegers;
    texels.normalized = allNormalized;
    texels.mapping = allNormalized ? NormalizedMapping(texels.smallestScalar, texels.largestScalar)
                                   : FloatMapping(texels.smallestScalar, texels.largestScalar);
  }
  return all;
}

std::vector<float> TexelsAsFloats(const ScalarRegion& region, const ScalarTexels& texels)
{
  const glm::ivec3 count = region.voxels.count;
  std::vector<float> floats(std::size_t(count.x) * count.y * count.z);
  ConvertComponent(region.components.front(),
    { region.dimensions, region.voxels, 1, texels.mapping }, floats.data());
  return floats;
}

// vtkTextureObject::AllocateProxyTexture3D does the same, but reports a refusal as an error.
std::size_t VolumeTexture::MostTexels(
  glm::ivec3 dimensions, const std::vector<ScalarTexels>& texels)
{
  const auto isTaken = [&]
  {
    glTexImage3D(GL_PROXY_TEXTURE_3D, 0, InternalFormatOf(texels), dimensions.x, dimensions.y,
      dimensions.z, 0, FormatOfComponents[texels.size() - 1], GL_FLOAT, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
    return width == dimensions.x;
  };
  while (!isTaken() && dimensions != glm::ivec3(1))
  {
    int* const longest = std::max_element(&dimensions.x, &dimensions.x + 3);
    *longest = (*longest + 1) / 2;
  }
  return std::size_t(dimensions.x) * dimensions.y * dimensions.z;
}

void VolumeTexture::Upload(vtkOpenGLRenderWindow* window, const ScalarRegion& region,
  const std::vector<ScalarTexels>& texels)
{
  const bool normalized = texels.front().normalized;
  const int components = int(region.components.size());
  const glm::ivec3 size = region.voxels.count;
  AllocateTexture3D(this->texture, window, size, normalized ? VTK_UNSIGNED_SHORT : VTK_FLOAT,
    InternalFormatOf(texels), components, "a volume");
  this->bytes = std::size_t(size.x) * size.y * size.z * components * texels.front().BytesPerTexel();

  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  this->allFinite =
    normalized ? UploadSlices<std::uint16_t>(region, texels) : UploadSlices<float>(region, texels);
  this->texture->Deactivate();
}

void VolumeTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
