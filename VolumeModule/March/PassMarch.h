#ifndef Varimarch_March_PassMarch_h
#define Varimarch_March_PassMarch_h

#include "Core/Geometry/Viewport.h"
#include "March/Device/BoxDrawing.h"
#include "March/FrameMarcher.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/SceneResources.h"

#include <cstddef>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Draws the passes other than the plain image: layers between translucent geometry, selections,
/// and images of colours and depths, which it keeps.
class PassMarch
{
public:
  explicit PassMarch(const SceneResources& resources)
    : resources(resources)
  {
  }

  /// @throws std::runtime_error if the volume is in blocks
  void Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);

  /// Draws the images of colours and depths.
  /// @throws std::runtime_error if the volume is in blocks
  void DrawImages(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);

  /// The pixels of the images; empty if there are no images.
  const Viewport& ImagePixels() const { return this->imagePixels; }
  /// The image of colours as premultiplied RGBA.
  std::vector<float> ColorImage(vtkOpenGLRenderWindow* window);
  /// The image of depths as RGBA, with 1 - depth in the red channel.
  std::vector<float> DepthImage(vtkOpenGLRenderWindow* window);

  std::size_t Bytes() const { return this->images.Bytes(); }
  void Release(vtkWindow* window);

private:
  const SceneResources& resources;
  FloatFramebuffer images{ 2 };
  Viewport imagePixels = {};
};

/// Fills an image of VTK_UNSIGNED_CHAR from premultiplied RGBA, over transparent white, as VTK's
/// mapper does.
void FillColorImage(const std::vector<float>& rgba, int width, int height, vtkImageData* image);

/// Fills an image of depths: 0 at the near plane, 1 at the far plane and on rays without a depth.
/// Integers span the range of their type.
/// @param rgba  1 - depth in the red channel
void FillDepthImage(
  const std::vector<float>& rgba, int width, int height, int scalarType, vtkImageData* image);

/// Draws an image with fewer or more rays than pixels. The rays are drawn into a framebuffer of
/// their own; the pixels are then interpolated between rays, or averaged.
class ResampledMarch
{
public:
  ResampledMarch(const SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  void Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher);

  std::size_t Bytes() const { return this->rays.Bytes(); }
  void Release(vtkWindow* window) { this->rays.Release(window); }

private:
  const SceneResources& resources;
  BoxDrawing& boxes;
  FloatFramebuffer rays;
};

}

#endif
