// What is drawn in the picture's place: translucent geometry's layers of it, selections, images.

#include "March/RayMarcher.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolume.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <stdexcept>

namespace varimarch
{

void RayMarcher::DrawPass(const Frame& frame)
{
  if (this->volume.Blocks().Partition().Count() > 1)
  {
    throw std::runtime_error("A volume in blocks is not drawn between translucent geometry, nor "
                             "selected: the maximum graphics memory, or the device's 3D textures, "
                             "are too small for it");
  }
  this->DrawVolume(frame);
}

void RayMarcher::DrawImages(const Frame& frame, const Viewport& rays)
{
  Frame images = frame;
  images.viewport = rays;
  images.settings.pass = RayPass::PictureAndDepth;
  this->picture.images.Draw(frame.window, rays, [&] { this->DrawPass(images); });
  this->picture.imagePixels = rays;
}

void RayMarcher::SetPassUniforms(const Frame& frame, const glm::dmat4& clipFromGrid)
{
  const RayPass pass = frame.settings.pass;
  if (Peels(pass) || pass == RayPass::PictureAndDepth)
  {
    this->program.Set("clipDepthRow", glm::row(clipFromGrid, 2));
    this->program.Set("clipWeightRow", glm::row(clipFromGrid, 3));
  }
  if (Peels(pass))
  {
    frame.volumePass.renderPass->SetShaderParameters(
      this->program.Program(), nullptr, frame.volume, nullptr);
  }
  if (pass == RayPass::PictureAndDepth)
  {
    this->program.Set("leastOpacity", LeastDepthOpacity);
    this->program.Set("clampDepth", int(frame.clampDepth));
  }
  if (Picks(pass))
  {
    this->program.Set("leastOpacity", LeastPickedOpacity);
  }
  if (pass == RayPass::PickProp)
  {
    const float* color = frame.volumePass.propColor;
    this->program.Set("propColor", glm::dvec3(color[0], color[1], color[2]));
  }
  if (pass == RayPass::PickVoxel)
  {
    // A voxel is a point, or a cell that lies half a voxel behind its first point.
    const int cells = frame.volumePass.picksCells ? 1 : 0;
    const int voxelsAreCells = frame.blanking.place == VoxelPlace::Cells ? 1 : 0;
    const glm::ivec3 count = frame.geometry.dimensions + voxelsAreCells - cells;
    this->program.Set("pickedCount", glm::dvec3(glm::max(count, 1)));
    this->program.Set("pickedOffset", 0.5 * (1 + voxelsAreCells - cells));
    this->program.Set("pickedHighestBits", int(frame.volumePass.highestBits));
  }
}

std::vector<float> RayMarcher::ColorImage()
{
  return this->picture.images.Read(this->window, this->picture.imagePixels, 0);
}

std::vector<float> RayMarcher::DepthImage()
{
  return this->picture.images.Read(this->window, this->picture.imagePixels, 1);
}

}
