#ifndef Varimarch_Benchmarks_Comparison_ComparisonVolume_h
#define Varimarch_Benchmarks_Comparison_ComparisonVolume_h

#include "ComparisonProgram.h"
#include "Core/Geometry/ScalarGrid.h"
#include "Core/Look/OpticalTable.h"
#include "Frame/VolumeGeometry.h"
#include "VoxelStorage.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The choice of the shaders' slot Shadow without shadows.
inline const std::string NoShadow = "Shadow/None.glsl";

/// Lets a texture interpolate linearly and continue its edges.
void FilterLinearly(vtkTextureObject* texture);

/// The form in which voxels and look are stored.
struct ComparedForm
{
  VoxelStorage voxels = VoxelStorage::Bits16;
  /// Length of steps for which the table has opacities instead of extinctions [mm]; 0: none.
  double correctedStepMm = 0.0;
};

/// The voxels and the look of a volume on the device, as comparison methods read them: one
/// component, a transfer function of one value, and a light at the eye or far away.
class ComparisonVolume
{
public:
  /// Uploads what has changed since the last call.
  /// @throws std::invalid_argument if the volume has not exactly one component
  void Update(vtkOpenGLRenderWindow* window, vtkImageData* image, vtkVolume* volume,
    const ComparedForm& form);

  /// Sets the uniforms that all fragment shaders with a look have, and activates the textures.
  /// @param eyeGrid  the eye in homogeneous coordinates
  void SetUniforms(ComparisonProgram& program, const glm::dvec4& eyeGrid) const;

  /// The files of a fragment shader that gives samples their look.
  /// @param main  file with main()
  /// @param shadow  file of the slot Shadow; another than NoShadow replaces the light at the eye by
  ///                a distant one
  std::vector<std::string> FragmentFiles(
    const std::string& main, const std::string& shadow = NoShadow) const;
  /// The same for a shader that reads the slices of a stack.
  std::vector<std::string> FragmentFilesOfStack(const std::string& main) const;

  /// The slices across an axis as 2D textures; made at the first call after a change.
  const std::vector<vtkSmartPointer<vtkTextureObject>>& Stack(
    vtkOpenGLRenderWindow* window, int axis);

  const VolumeGeometry& Geometry() const { return this->geometry; }

  /// The voxels in [0, 1] over the values of the volume, and the extinction [1/mm] of such a value.
  ScalarGrid<float> Texels() const { return { this->texels.data(), this->geometry.dimensions }; }
  double Extinction(double texel) const;

  /// A number that grows with each change of the voxels or the look.
  int Version() const { return this->version; }
  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void ReadVoxels();
  void UploadTable(vtkOpenGLRenderWindow* window, vtkVolume* volume);
  std::vector<std::string> FilesWith(
    std::vector<std::string> voxelFiles, const std::string& main, const std::string& shadow) const;

  vtkSmartPointer<vtkImageData> image;
  vtkMTimeType imageTime = 0;
  ComparedForm form;
  vtkMTimeType propertyTime = 0;
  VolumeGeometry geometry;
  std::vector<float> texels; ///< in [0, 1] over the values of the volume
  double smallest = 0.0;
  double range = 1.0; ///< the largest value less the smallest
  bool shaded = false;
  glm::vec4 reflectance = glm::vec4(0.0f);
  OpticalTable optical;
  IndexInTable index = { 0.0, 0.0 }; ///< index of a texel in the table
  int version = 0;
  std::size_t voxelBytes = 0;
  vtkNew<vtkTextureObject> voxels;
  vtkNew<vtkTextureObject> table;
  vtkNew<vtkOpenGLBufferObject> tableBuffer;
  std::array<std::vector<vtkSmartPointer<vtkTextureObject>>, 3> stacks;
};

/// The view of a frame that a comparison method draws.
struct ComparedView
{
  vtkOpenGLRenderWindow* window;
  glm::ivec2 sizePixels;
  glm::ivec2 originPixels; ///< lower left corner in the framebuffer
  glm::dmat4 clipFromGrid;
  glm::dvec4 eyeGrid; ///< homogeneous; at infinity for a parallel projection
  glm::dvec3 eyeWorld;
  glm::dvec3 directionWorld; ///< unit vector in which the camera looks
  glm::dvec3 upWorld;        ///< unit vector, across the direction
  bool isParallel;
};

ComparedView ComparedViewOf(vtkRenderer* renderer, const VolumeGeometry& geometry);

/// Everything that a comparison method draws with. The image begins transparent.
struct ComparisonFrame
{
  const ComparedView& view;
  ComparisonVolume& volume;
  ComparisonProgram& program;
  double sampleDistanceMm; ///< > 0
  glm::dvec3 toLightWorld; ///< direction towards a distant light, a unit vector

  /// Makes a program with the volume's look current, and sets the uniforms of its slots.
  /// @param main    file with main(), for a fragment shader
  /// @param shadow  file of the slot Shadow
  void Use(const std::string& main, const std::string& shadow = NoShadow) const;
};

}

#endif
