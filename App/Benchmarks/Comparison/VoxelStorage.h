#ifndef Varimarch_Benchmarks_Comparison_VoxelStorage_h
#define Varimarch_Benchmarks_Comparison_VoxelStorage_h

#include <vtkTextureObject.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The ways to store a volume on the device that are compared: M. Banquero, E. Ortiz, B. Rossi,
/// "Realtime volume render en videojuegos" (2016), section 3.1. A texture filters the first two in
/// three directions, and in two directions those with four voxels in a texel and those in a 2D
/// texture. Voxels in words are read one by one, eight for each value.
enum class VoxelStorage
{
  Bits16,       ///< a 3D texture of 16 bits per voxel, as in the product
  Bits8,        ///< a 3D texture of 8 bits per voxel
  FourInTexel,  ///< RGBA8: four voxels along z in a texel of a 3D texture
  FourInTexel4, ///< RGBA4: the same with 4 bits per voxel
  Bits6,        ///< five voxels along z in a word of 32 bits
  Bit1,         ///< 32 voxels along z in a word of 32 bits
  Slices2D,     ///< slices side by side in a 2D texture of 16 bits per voxel
};

/// The largest number that a voxel can be; the numbers from 0 on stand for equally distant values.
int LargestStoredLevel(VoxelStorage storage);

/// The shader files that read values, from the folder Voxels.
std::vector<std::string> ShaderFilesOf(VoxelStorage storage);

/// Voxels as numbers in [0, 1], x fastest.
struct NormalizedVoxels
{
  const std::vector<float>& values;
  glm::ivec3 size;
};

/// Uploads voxels, each rounded to the nearest of its levels.
/// @throws std::runtime_error if the device has no texture of that size
void UploadVoxels(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, VoxelStorage storage,
  const NormalizedVoxels& voxels);

/// The memory of a texture, by the bits that the device says its texels have [bytes].
std::size_t TextureBytes(vtkTextureObject* texture);

}

#endif
