#include "March/Processor/PacketMarcher.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/Quality/MarchWork.h"
#include "Core/Quality/TrialRays.h"
#include "March/DrawingStopped.h"
#include "March/Processor/PacketScenes.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>

namespace varimarch
{

namespace
{

// The pixels of a viewport inside the scissor box.
Viewport WithinScissors(const Viewport& pixels, const Viewport& viewport, vtkOpenGLState* state)
{
  Viewport drawn = pixels;
  if (!state->GetEnumState(GL_SCISSOR_TEST))
  {
    return drawn;
  }
  GLint box[4];
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, box);
  const auto cut = [](int& begin, int& count, int from, int fromCount)
  {
    const int end = std::min(begin + count, from + fromCount);
    begin = std::max(begin, from);
    count = std::max(end - begin, 0);
  };
  cut(drawn.left, drawn.width, box[0] - viewport.left, box[2]);
  cut(drawn.bottom, drawn.height, box[1] - viewport.bottom, box[3]);
  return drawn;
}

// Places do not depend on light.
void LeaveOutLight(PacketScene& scene)
{
  scene.light.castsShadows = false;
  scene.sky.strength = 0.0f;
}

// The scenes whose images or depths Shaders/Marched combines into pixels.
std::vector<PacketScene> PartsOf(
  const PacketScene& scene, const VolumeMarch& march, const std::vector<float>& layerDepths)
{
  PacketScene other = scene;
  if (Peels(march.settings.pass))
  {
    PacketScene front = scene;
    front.cuts.layers = layerDepths.data();
    other.cuts.layers = layerDepths.data() + 2;
    return { front, other };
  }
  if (march.settings.pass == RayPass::PictureAndDepth)
  {
    const bool clampDepth = march.frame.image.clampDepth;
    other.location = { LeastDepthOpacity, 0.0f, clampDepth };
    LeaveOutLight(other);
    other.depths =
      clampDepth ? PacketDepths() : scene.depths; // the back face may lie behind the visible part
    return { scene, other };
  }
  if (march.settings.pass == RayPass::PickVoxel)
  {
    other.location = { 0.5f, LeastPickedOpacity, false };
    LeaveOutLight(other);
  }
  return { other };
}

// The depths of the pixels that the rays of a trial image belong to.
std::vector<float> TrialDepthsOf(const PacketSurroundings& around, const MarchPlan& plan)
{
  const float* const depths = around.textures.depthTexture.Texels<float>();
  const glm::ivec2 rays(plan.viewport.width, plan.viewport.height);
  const glm::dvec2 texels(around.depthPixels);
  std::vector<float> tried;
  for (int i = 0; i < rays.x * rays.y; ++i)
  {
    const glm::ivec2 pixel = TrialPixelOf({ i % rays.x, i / rays.x }, rays, plan.ImagePixels());
    const glm::ivec2 texel((glm::dvec2(pixel) + 0.5) * texels / glm::dvec2(plan.ImagePixels()));
    tried.push_back(depths[std::ptrdiff_t(texel.y) * around.depthPixels.x + texel.x]);
  }
  return tried;
}

// The scene of a block of rays, whose pixels in the image are equally far apart.
PacketScene SceneOfBlock(const PacketScene& scene, const Viewport& block, const glm::ivec2& rays,
  const glm::ivec2& imagePixels)
{
  const glm::ivec2 corner(block.left, block.bottom);
  const glm::ivec2 first = TrialPixelOf(corner, rays, imagePixels);
  const glm::dvec2 apart(TrialPixelOf(corner + 1, rays, imagePixels) - first);
  PacketScene moved = scene;
  moved.rays.viewportPixelsInverse = apart / glm::dvec2(imagePixels);
  moved.rays.viewportOriginPixels = glm::dvec2(corner) + 0.5 - (glm::dvec2(first) + 0.5) / apart;
  return moved;
}

/// One of several images of the same rays.
struct PacketImage
{
  const PacketScene* scene;
  float* rgba; ///< See MarchPackets.
};

// Marches the rays of trial images, each packet through all images before the next: voxels that do
// not fit in memory are read for all images at once.
// @param work  see MarchPackets
void MarchBlocks(const std::vector<PacketImage>& images, const Viewport& pixels,
  const glm::ivec2& imagePixels, MarchWork* work)
{
  const glm::ivec2 rays(pixels.width, pixels.height);
  const glm::ivec2 size(PacketWidth, PacketHeight);
  const glm::ivec2 count = (rays + size - 1) / size;
  if (work)
  {
    work->Begin(count.x * count.y);
  }
  std::atomic<int> next = 0;
  tbb::parallel_for(0, count.x * count.y,
    [&](int)
    {
      if (work && work->IsStopped())
      {
        return;
      }
      const int i = next++; // in turn, so that cores read voxels that lie together
      const glm::ivec2 corner = glm::ivec2(i % count.x, i / count.x) * size;
      const glm::ivec2 inside = glm::min(size, rays - corner);
      const Viewport block{ corner.x, corner.y, inside.x, inside.y };
      for (const PacketImage& image : images)
      {
        std::array<float, 4 * PacketWidth * PacketHeight> rgba;
        MarchPackets(SceneOfBlock(*image.scene, block, rays, imagePixels), block, rgba.data());
        for (int row = 0; row < inside.y; ++row)
        {
          std::copy_n(&rgba[std::size_t(4 * inside.x * row)], 4 * inside.x,
            image.rgba + 4 * (std::ptrdiff_t(corner.y + row) * rays.x + corner.x));
        }
      }
      if (work)
      {
        work->EndPacket();
      }
    });
}

void StopIfUnwanted(const MarchPlan& plan)
{
  if (plan.work && plan.work->IsUnwanted())
  {
    throw DrawingStopped();
  }
}

using glm::clamp;
using glm::vec2;
using glm::vec4;
#include "Shaders/Math/WindowLevel.glsl"

void Window(std::vector<float>& rgba, const vec2& scaleBias)
{
  for (std::size_t i = 0; i < rgba.size(); i += 4)
  {
    const vec4 windowed =
      WindowedColor({ rgba[i], rgba[i + 1], rgba[i + 2], rgba[i + 3] }, scaleBias);
    std::copy_n(&windowed.x, 4, &rgba[i]);
  }
}

}

void PacketMarcher::Draw(const Frame& frame, const MarchPlan& plan)
{
  if (this->resources.IsNothingDrawn())
  {
    return;
  }
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = CoverOfRays(frame, plan, drawn.coverGrid);
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.view.renderer) * frame.geometry.worldFromGrid;
  const Viewport pixels = WithinScissors(PixelsOf(drawn.coverGrid, clipFromGrid, plan.viewport),
    plan.viewport, frame.view.window->GetState());
  if (pixels.width == 0 || pixels.height == 0)
  {
    return;
  }
  const VolumeMarch march = MarchOf(frame, plan);
  const PacketScenes scenes(march, this->resources, this->SurroundingsOf(frame, plan), pixels);
  this->image.March(
    frame.view.window, PartsOf(scenes.Scene(), march, scenes.LayerDepths()), pixels, plan.work);

  StopIfUnwanted(plan);
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = this->image.Pixels();
  this->boxes.Draw(frame, plan.WithRole(ShaderRole::ShowMarchedImage), drawn, earlier);
}

std::vector<std::vector<float>> PacketMarcher::DrawTrials(
  const Frame& frame, const std::vector<MarchPlan>& plans)
{
  const Viewport& pixels = plans.front().viewport;
  std::vector<std::vector<float>> drawn(
    plans.size(), std::vector<float>(4 * std::size_t(pixels.width) * pixels.height));
  if (this->resources.IsNothingDrawn())
  {
    return drawn;
  }
  std::deque<PacketScenes> scenes;
  std::vector<PacketImage> images;
  for (std::size_t i = 0; i < plans.size(); ++i)
  {
    scenes.emplace_back(
      MarchOf(frame, plans[i]), this->resources, this->SurroundingsOf(frame, plans[i]), pixels);
    images.push_back({ &scenes.back().Scene(), drawn[i].data() });
  }
  MarchBlocks(images, pixels, plans.front().ImagePixels(), plans.front().work);
  StopIfUnwanted(plans.front());
  for (std::vector<float>& rgba : drawn)
  {
    if (frame.settings.windowLevel)
    {
      Window(rgba, frame.image.windowScaleBias);
    }
  }
  return drawn;
}

PacketSurroundings PacketMarcher::SurroundingsOf(const Frame& frame, const MarchPlan& plan)
{
  PacketSurroundings around = {};
  around.drawnBox = this->resources.DrawnBox();
  if (frame.settings.sceneGeometry)
  {
    this->resources.Depth().Read(frame.view.window);
    around.depthPixels = this->resources.Depth().SizePixels();
  }
  around.textures = this->resources.Textures();
  if (plan.isTrial && around.textures.depthTexture)
  {
    around.trialDepths = TrialDepthsOf(around, plan);
    around.depthPixels = { plan.viewport.width, plan.viewport.height };
    around.textures.depthTexture.inMemory = around.trialDepths.data();
  }
  if (frame.settings.mask == Mask::Labels)
  {
    const VolumeResources& first = this->resources.First();
    around.labelRows =
      PacketRowsOf(first.Materials().OpticalTables(), first.Packets().Mappings().front());
  }
  if (Peels(plan.pass))
  {
    around.layerDepths = this->DrawLayerDepths(frame, plan);
  }
  return around;
}

std::vector<float> PacketMarcher::DrawLayerDepths(const Frame& frame, const MarchPlan& plan)
{
  this->layerDepths.Draw(frame.view.window, plan.viewport,
    [&]
    {
      this->boxes.Draw(frame, plan.WithRole(ShaderRole::WriteLayerDepths),
        AllThatIsVisible(this->resources.DrawnBox()));
    });
  return this->layerDepths.Read(frame.view.window, plan.viewport);
}

void PacketMarcher::Release(vtkWindow* window)
{
  this->image.Release(window);
  this->layerDepths.Release(window);
}

}
