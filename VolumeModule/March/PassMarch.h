#ifndef Varimarch_March_PassMarch_h
#define Varimarch_March_PassMarch_h

#include "Core/Geometry/Viewport.h"
#include "March/FrameMarcher.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/SceneResources.h"

#include <cstddef>
#include <vector>

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

}

#endif
