#ifndef Varimarch_March_Device_BoxDrawing_h
#define Varimarch_March_Device_BoxDrawing_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Viewport.h"
#include "Frame/MarchPlan.h"
#include "March/Device/RayMarchProgram.h"
#include "Resources/SceneResources.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkShaderProgram;

namespace varimarch
{

/// The volume's box as triangles in grid space. Its inner faces cover each pixel whose ray meets
/// the volume exactly once, wherever the camera is.
class VolumeBoxGeometry
{
public:
  /// Draws the box with a program that takes positions as vertexGrid.
  void Draw(vtkShaderProgram* program, const Box& boxGrid);
  void Release();

private:
  // The handle of the program that has the attributes. A program gets another one when a window
  // that shares it is closed.
  int attributesOf = 0;
  Box uploaded = { glm::dvec3(0.0), glm::dvec3(0.0) };
  vtkNew<vtkOpenGLBufferObject> vertices;
  vtkNew<vtkOpenGLBufferObject> triangles;
  vtkNew<vtkOpenGLVertexArrayObject> attributes;
};

/// The part of a volume that a drawing covers.
struct DrawnBlock
{
  const VolumeBlock* block; ///< The textures of the part; null if the shader marches no rays.
  VoxelRegion voxels;
  Box boxGrid;                ///< The box that rays are marched through.
  Box coverGrid;              ///< The box that is rasterised; it covers the pixels of the rays.
  glm::dvec3 sharedUpperGrid; ///< Upper faces shared with another block; far away otherwise.
};

/// The part that a drawing covers if its shader marches no rays: all pixels of the volume.
/// @param drawnBox  the box that rays are marched through
DrawnBlock AllThatIsVisible(const Box& drawnBox);

/// A larger box that covers every pixel that the given box touches, if the given box is at least a
/// few pixels wide.
Box WithItsEdges(const Box& box);

/// A box that covers all pixels of the view.
Box CoverOfView(const Frame& frame);

/// The box that a drawing rasterises for its rays through a box. The rays of a trial image may be
/// beside the centres of its pixels by as much as their width, so it covers the whole view.
Box CoverOfRays(const Frame& frame, const MarchPlan& plan, const Box& box);

/// The results of earlier drawings that a drawing reads; null and zero if its pass needs none.
struct EarlierDrawings
{
  vtkTextureObject* gathered = nullptr; ///< The sums of the rays over earlier blocks.
  vtkTextureObject* coarse = nullptr;   ///< An image of fewer or more rays than pixels.
  vtkTextureObject* sum = nullptr;      ///< The sum of images that are accumulated.
  int imageCount = 0;                   ///< The number of images in the sum.
  int rowsOfNext = 0;                   ///< The number of rows of the next image in the sum.
  vtkTextureObject* marched = nullptr;  ///< The image that the processor has marched.
  Viewport marchedPixels = {};          ///< The pixels of that image.
};

/// Draws boxes with the shader program of a march. It draws the inner faces of a box, so that one
/// ray starts in each of its pixels, wherever the camera is. Owns the programs, their parameters
/// and their geometry.
class BoxDrawing
{
public:
  explicit BoxDrawing(SceneResources& resources)
    : resources(resources)
  {
  }

  /// Draws into the current framebuffer.
  /// @throws std::runtime_error if the shader cannot be compiled
  void Draw(const Frame& frame, const MarchPlan& plan, const DrawnBlock& drawn,
    const EarlierDrawings& earlier = {});

  int ShaderBuilds() const { return this->shaderBuilds; }
  /// The files of the shader that marched rays last; empty if the processor marched.
  const std::vector<std::string>& ShaderParts() const { return this->shaderParts; }
  void Release();

private:
  void UpdateProgram(const VolumeMarch& march);
  RayParameters ParametersOfRays(
    const VolumeMarch& march, const DrawnBlock& drawn, const EarlierDrawings& earlier);
  RayTextures TexturesOfRays(const EarlierDrawings& earlier);
  void SetVolumes(const VolumeMarch& march, const DrawnBlock& drawn);
  void SetParameters(
    const VolumeMarch& march, const DrawnBlock& drawn, const EarlierDrawings& earlier);

  SceneResources& resources;
  VolumeBoxGeometry boxGeometry;
  RayMarchProgram program;
  int shaderBuilds = 0;
  std::vector<std::string> shaderParts;
};

}

#endif
