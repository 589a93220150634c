#include "VoxelStorage.h"

#include "Resources/VolumeTexture.h"
#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr int BitsOfWord = 32;

/// The format of a texture, in the numbers of OpenGL and VTK.
struct TextureFormat
{
  GLenum internal;
  GLenum format;
  int vtkType;
  int components;
};

TextureFormat FormatOf(VoxelStorage storage)
{
  switch (storage)
  {
    case VoxelStorage::Bits8:
      return { GL_R8, GL_RED, VTK_UNSIGNED_CHAR, 1 };
    case VoxelStorage::FourInTexel:
      return { GL_RGBA8, GL_RGBA, VTK_UNSIGNED_CHAR, 4 };
    case VoxelStorage::FourInTexel4:
      return { GL_RGBA4, GL_RGBA, VTK_UNSIGNED_CHAR, 4 };
    case VoxelStorage::Bits6:
    case VoxelStorage::Bit1:
      return { GL_R32UI, GL_RED_INTEGER, VTK_UNSIGNED_INT, 1 };
    default:
      return { GL_R16, GL_RED, VTK_UNSIGNED_SHORT, 1 };
  }
}

int LevelOf(VoxelStorage storage, float value)
{
  return int(std::lround(double(value) * LargestStoredLevel(storage)));
}

// Calls `put` with the index and the position of each voxel, slices in parallel.
template <class Put>
void ForEachVoxel(glm::ivec3 size, const Put& put)
{
  tbb::parallel_for(0, size.z,
    [&](int z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          put((std::size_t(z) * size.y + y) * size.x + x, glm::ivec3(x, y, z));
        }
      }
    });
}

// One number for each voxel, with all levels of its type.
template <class Number>
std::vector<Number> Separate(VoxelStorage storage, const NormalizedVoxels& voxels)
{
  std::vector<Number> numbers(voxels.values.size());
  ForEachVoxel(voxels.size,
    [&](std::size_t index, glm::ivec3)
    { numbers[index] = Number(LevelOf(storage, voxels.values[index])); });
  return numbers;
}

// Four voxels along z in the components of a texel. OpenGL takes bytes and keeps as many of their
// bits as the texture has: a multiple of 17 says the same in 4 and in 8 bits.
std::vector<std::uint8_t> FourInTexel(VoxelStorage storage, const NormalizedVoxels& voxels)
{
  const glm::ivec3 size = voxels.size;
  const int byteOfLevel = 255 / LargestStoredLevel(storage);
  std::vector<std::uint8_t> bytes(4 * std::size_t((size.z + 3) / 4) * size.y * size.x);
  ForEachVoxel(size,
    [&](std::size_t index, glm::ivec3 voxel)
    {
      const std::size_t texel = (std::size_t(voxel.z / 4) * size.y + voxel.y) * size.x + voxel.x;
      bytes[4 * texel + voxel.z % 4] =
        std::uint8_t(byteOfLevel * LevelOf(storage, voxels.values[index]));
    });
  return bytes;
}

// Words that hold several voxels along z, the first one in the lowest bits.
std::vector<std::uint32_t> InWords(
  VoxelStorage storage, int voxelsPerWord, const NormalizedVoxels& voxels)
{
  const glm::ivec3 size = voxels.size;
  const int bits = BitsOfWord / voxelsPerWord;
  const std::size_t slice = std::size_t(size.x) * size.y;
  const int layers = (size.z + voxelsPerWord - 1) / voxelsPerWord;
  std::vector<std::uint32_t> words(slice * layers);
  tbb::parallel_for(0, layers,
    [&](int layer)
    {
      const int last = std::min((layer + 1) * voxelsPerWord, size.z);
      for (int z = layer * voxelsPerWord; z < last; ++z)
      {
        for (std::size_t i = 0; i < slice; ++i)
        {
          const auto level = std::uint32_t(LevelOf(storage, voxels.values[slice * z + i]));
          words[slice * layer + i] |= level << (bits * (z % voxelsPerWord));
        }
      }
    });
  return words;
}

[[noreturn]] void Refuse(glm::ivec3 size, const std::string& reason)
{
  std::ostringstream message;
  message << "A comparison method cannot store a volume of " << size.x << " x " << size.y << " x "
          << size.z << " voxels: " << reason;
  throw std::runtime_error(message.str());
}

template <class Number>
void Upload3D(
  vtkTextureObject* texture, VoxelStorage storage, glm::ivec3 texels, std::vector<Number> numbers)
{
  const TextureFormat format = FormatOf(storage);
  const glm::uvec3 size(texels);
  if (!texture->Create3DFromRaw(
        size.x, size.y, size.z, format.components, format.vtkType, numbers.data()))
  {
    Refuse(texels, "the device has no texture of that size");
  }
}

// The slices in rows, of about as many columns as rows.
void UploadSlices2D(
  vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const NormalizedVoxels& voxels)
{
  const glm::ivec3 size = voxels.size;
  const int longestSide = vtkTextureObject::GetMaximumTextureSize(window);
  const double square = std::sqrt(double(size.z) * size.y / size.x);
  const int columns = std::clamp(int(std::lround(square)), 1, std::max(longestSide / size.x, 1));
  const int rows = (size.z + columns - 1) / columns;
  const std::size_t width = std::size_t(columns) * size.x;
  const std::size_t height = std::size_t(rows) * size.y;
  if (std::max(width, height) > std::size_t(longestSide))
  {
    Refuse(size,
      "its slices need a 2D texture of " + std::to_string(width) + " x " + std::to_string(height) +
        ", and the device has at most " + std::to_string(longestSide) + " on a side");
  }
  std::vector<std::uint16_t> pixels(width * height);
  ForEachVoxel(size,
    [&](std::size_t index, glm::ivec3 voxel)
    {
      const std::size_t x = std::size_t(voxel.z % columns) * size.x + voxel.x;
      const std::size_t y = std::size_t(voxel.z / columns) * size.y + voxel.y;
      pixels[y * width + x] = std::uint16_t(LevelOf(VoxelStorage::Slices2D, voxels.values[index]));
    });
  if (!texture->Create2DFromRaw(
        unsigned(width), unsigned(height), 1, VTK_UNSIGNED_SHORT, pixels.data()))
  {
    Refuse(size, "the device has no memory for a 2D texture of its slices");
  }
}

constexpr int VoxelsPerWord(VoxelStorage storage)
{
  return storage == VoxelStorage::Bit1 ? BitsOfWord : BitsOfWord / 6;
}

}

int LargestStoredLevel(VoxelStorage storage)
{
  switch (storage)
  {
    case VoxelStorage::Bits8:
    case VoxelStorage::FourInTexel:
      return 255;
    case VoxelStorage::Bits6:
      return 63;
    case VoxelStorage::FourInTexel4:
      return 15;
    case VoxelStorage::Bit1:
      return 1;
    default:
      return 65535;
  }
}

std::vector<std::string> ShaderFilesOf(VoxelStorage storage)
{
  switch (storage)
  {
    case VoxelStorage::FourInTexel:
    case VoxelStorage::FourInTexel4:
      return { "Voxels/FourInTexel.glsl" };
    case VoxelStorage::Bits6:
      return { "Voxels/SixBits.glsl", "Voxels/EightReads.glsl" };
    case VoxelStorage::Bit1:
      return { "Voxels/OneBit.glsl", "Voxels/EightReads.glsl" };
    case VoxelStorage::Slices2D:
      return { "Voxels/SlicesSideBySide.glsl" };
    default:
      return { "Voxels/Texture3D.glsl" };
  }
}

void UploadVoxels(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, VoxelStorage storage,
  const NormalizedVoxels& voxels)
{
  const glm::ivec3 size = voxels.size;
  const auto layers = [&](int voxelsPerLayer)
  { return glm::ivec3(size.x, size.y, (size.z + voxelsPerLayer - 1) / voxelsPerLayer); };
  const TextureFormat format = FormatOf(storage);
  texture->ReleaseGraphicsResources(window);
  texture->ResetFormatAndType();
  texture->SetContext(window);
  texture->SetInternalFormat(format.internal);
  texture->SetFormat(format.format);
  SetVolumeFilter(texture, LargestStoredLevel(storage) <= 255);
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  switch (storage)
  {
    case VoxelStorage::Bits16:
      Upload3D(texture, storage, size, Separate<std::uint16_t>(storage, voxels));
      break;
    case VoxelStorage::Bits8:
      Upload3D(texture, storage, size, Separate<std::uint8_t>(storage, voxels));
      break;
    case VoxelStorage::FourInTexel:
    case VoxelStorage::FourInTexel4:
      Upload3D(texture, storage, layers(4), FourInTexel(storage, voxels));
      break;
    case VoxelStorage::Bits6:
    case VoxelStorage::Bit1:
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      Upload3D(texture, storage, layers(VoxelsPerWord(storage)),
        InWords(storage, VoxelsPerWord(storage), voxels));
      break;
    case VoxelStorage::Slices2D:
      UploadSlices2D(window, texture, voxels);
      break;
  }
}

std::size_t TextureBytes(vtkTextureObject* texture)
{
  texture->Activate();
  std::size_t bits = 0;
  for (const GLenum component :
    { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE })
  {
    GLint ofComponent = 0;
    glGetTexLevelParameteriv(texture->GetTarget(), 0, component, &ofComponent);
    bits += std::size_t(ofComponent);
  }
  texture->Deactivate();
  return bits * texture->GetWidth() * texture->GetHeight() * std::max(texture->GetDepth(), 1u) / 8;
}

}
