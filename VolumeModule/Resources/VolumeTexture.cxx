#include "Resources/VolumeTexture.h"

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
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace varimarch
{

namespace
{

template <class Texel>
constexpr double LargestInteger = double(std::numeric_limits<Texel>::max());

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
  const double factor = (normalized ? LargestInteger<Texel> : 1.0) / mapping.scale;
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
constexpr GLint Format8OfComponents[] = { GL_R8, GL_RG8, GL_RGB8, GL_RGBA8 };
constexpr GLint Format16OfComponents[] = { GL_R16, GL_RG16, GL_RGB16, GL_RGBA16 };
constexpr GLint FormatFloatOfComponents[] = { GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F };

/// Converts and uploads a few slices at a time, so that memory never holds a second copy of the
/// volume.
/// @return true if all scalars are finite
template <class Texel>
bool UploadSlices(const ScalarRegion& region, const std::vector<ScalarTexels>& texelsOfComponents,
  GLenum typeOfTexels)
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
      FormatOfComponents[components - 1], typeOfTexels, texels.data());
  }
  return allFinite;
}

GLenum InternalFormatOf(std::size_t components, TexelFormat format)
{
  switch (format)
  {
    case TexelFormat::Integers8:
      return Format8OfComponents[components - 1];
    case TexelFormat::Integers16:
      return Format16OfComponents[components - 1];
    default:
      return FormatFloatOfComponents[components - 1];
  }
}

int VtkTypeOf(TexelFormat format)
{
  switch (format)
  {
    case TexelFormat::Integers8:
      return VTK_UNSIGNED_CHAR;
    case TexelFormat::Integers16:
      return VTK_UNSIGNED_SHORT;
    default:
      return VTK_FLOAT;
  }
}

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

// llvmpipe filters texels of 8 bits in integers of 8 bits if the texture is repeated or clamped on
// every axis, but in floats if it is mirrored on one. A mirrored texture is the same as a clamped
// one up to a voxel beyond the outermost, which is as far as gradients read.
void SetVolumeFilter(vtkTextureObject* texture, bool isNarrow)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(isNarrow ? vtkTextureObject::MirroredRepeat : vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
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
  glm::ivec3 dimensions, std::size_t components, TexelFormat format)
{
  const auto isTaken = [&]
  {
    glTexImage3D(GL_PROXY_TEXTURE_3D, 0, InternalFormatOf(components, format), dimensions.x,
      dimensions.y, dimensions.z, 0, FormatOfComponents[components - 1], GL_FLOAT, nullptr);
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
  const std::vector<ScalarTexels>& texels, TexelFormat format)
{
  const int components = int(region.components.size());
  const glm::ivec3 size = region.voxels.count;
  AllocateTexture3D(this->texture, window, size, VtkTypeOf(format),
    InternalFormatOf(texels.size(), format), components, "a volume");
  this->bytes = std::size_t(size.x) * size.y * size.z * components * BytesOf(format);

  SetVolumeFilter(this->texture, format == TexelFormat::Integers8);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  switch (format)
  {
    case TexelFormat::Integers8:
      this->allFinite = UploadSlices<std::uint8_t>(region, texels, GL_UNSIGNED_BYTE);
      break;
    case TexelFormat::Integers16:
      this->allFinite = UploadSlices<std::uint16_t>(region, texels, GL_UNSIGNED_SHORT);
      break;
    case TexelFormat::Floats:
      this->allFinite = UploadSlices<float>(region, texels, GL_FLOAT);
      break;
  }
  this->texture->Deactivate();
}

void VolumeTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
