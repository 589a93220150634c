#include "March/Processor/PacketMarcher.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/Packets/PacketTwins.h"
#include "Core/Quality/MarchWork.h"
#include "Core/Quality/TrialRays.h"
#include "Core/Recipe/MarchRecipe.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/Device/GraphicsDriver.h"
#include "March/FrameMarcher.h"
#include "March/Processor/PacketSceneBuilder.h"
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
#include <set>
#include <string>
#include <utility>
#include <vector>

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
  const glm::dmat4 clipFromGrid = frame.ClipFromGrid();
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

namespace
{

// True if a shader file does nothing, something that a shader does for rays of packets too, or
// something in which devices differ and packets do not.
bool NeedsNoTwin(const std::string& file)
{
  static const std::set<std::string> nothing = { "None", "NoneOfAll", "Even" };
  static const std::set<std::string> slotsOfDevice = { "Difference", "Filter", "Locate", "Peel",
    "Pixel", "Resume", "Window" };
  const std::size_t slash = file.find('/');
  return slash == std::string::npos || slotsOfDevice.count(file.substr(0, slash)) > 0 ||
    nothing.count(file.substr(slash + 1, file.rfind('.') - slash - 1)) > 0;
}

// Twins that packets cannot combine: sums without interpolation, and what knows no splines.
bool AreApart(const std::set<std::string>& files)
{
  static const std::vector<std::pair<std::string, std::string>> pairs = {
    { "March/ProjectedVoxels.glsl", "Blend/AverageIntensity.glsl" },
    { "March/ProjectedVoxels.glsl", "Blend/Additive.glsl" },
    { "March/Projection.glsl", "Blend/MaximumIntensity.glsl" },
    { "March/Projection.glsl", "Blend/MinimumIntensity.glsl" },
    { "March/Isosurfaces.glsl", "Interpolation/CubicSpline.glsl" },
  };
  return std::any_of(pairs.begin(), pairs.end(),
    [&](const auto& pair) { return files.count(pair.first) > 0 && files.count(pair.second) > 0; });
}

// The files of the shader that would march.
std::vector<std::string> PartsOfMarch(RenderSettings settings)
{
  settings.role = ShaderRole::MarchRays;
  settings.pass = Marches(settings) ? settings.pass : RayPass::Whole;
  return FragmentShaderParts(settings);
}

// True if packets repeat all files of the shader that would march.
bool HasTwins(const RenderSettings& settings)
{
  const std::vector<std::string> parts = PartsOfMarch(settings);
  const std::set<std::string>& twins = ShaderFilesOfPackets();
  return !AreApart({ parts.begin(), parts.end() }) &&
    std::all_of(parts.begin(), parts.end(),
      [&](const std::string& file) { return NeedsNoTwin(file) || twins.count(file) > 0; });
}

// True if packets march a mixture; they do so by midpoints only.
bool MayMixByMidpoints(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool mayChoose = frame.quality.choosesIntegration || settings.overlaps || settings.nearest;
  return settings.blend == Blend::Composite &&
    (mayChoose || settings.integration == Integration::Midpoint);
}

// True if packets have code for everything that a frame requests.
bool HasPacketRecipe(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool isMixed = !IsMixture(frame) || MayMixByMidpoints(frame);
  const bool isLocated = frame.image.toImages || Locates(settings.pass);
  const bool hasMask =
    settings.mask == Mask::None || frame.voxels.mask.dimensions == frame.geometry.dimensions;
  const bool isSampledEvenly = !settings.uneven || (!isLocated && !settings.nearest);
  const bool hasPlaces = !isLocated || !IsProjection(settings.blend);
  return HasTwins(settings) && isMixed && isSampledEvenly && hasPlaces && hasMask;
}

bool IsFinite(VolumeResources& volume)
{
  return volume.Blocks().Texels().normalized || volume.Packets().AreFinite();
}

bool HasNoGaps(const Frame& frame, VolumeResources& volume)
{
  return !frame.voxels.blanking.Any() && IsFinite(volume);
}

// True if packets can number the voxels: those in memory by 64 bits, everything that belongs to
// voxels besides them by 32.
bool CanBeIndexed(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool hasOnlyVoxels =
    !settings.cubic && settings.mask == Mask::None && !settings.overlaps && !IsMixture(frame);
  return IsIndexedBy32Bits(frame.geometry.dimensions) ||
    (hasOnlyVoxels && HasNoGaps(frame, volume));
}

// True if packets can read the voxels although one may be alone along an axis, where it is there
// twice. Masks and gaps have the places of voxels in memory.
bool IsThickEnough(const Frame& frame, VolumeResources& volume)
{
  const glm::ivec3& voxels = frame.geometry.dimensions;
  const int fewest = std::min({ voxels.x, voxels.y, voxels.z });
  const RenderSettings& settings = frame.settings;
  const bool hasVoxelsAlone =
    settings.mask == Mask::None && !settings.uneven && HasNoGaps(frame, volume);
  return settings.cubic ? fewest >= 4 : fewest >= 2 || hasVoxelsAlone;
}

// Coarser levels of a volume are read as they are.
bool AreLevelsPlain(const Frame& frame, const VolumeResources& volume)
{
  const std::vector<TexelMapping>& mappings = volume.Packets().Mappings();
  return !frame.blockLevels ||
    std::all_of(mappings.begin(), mappings.end(),
      [](const TexelMapping& mapping) { return mapping == TexelMapping(); });
}

bool TakesGradients(const RenderSettings& settings)
{
  const std::vector<std::string> parts = PartsOfMarch(settings);
  return std::any_of(parts.begin(), parts.end(),
    [](const std::string& file) { return file.rfind("Gradient/", 0) == 0 && !NeedsNoTwin(file); });
}

// True if packets can draw the gaps of a volume. Gradients next to gaps are left to shaders.
bool HasPlainGaps(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool mayHave = !settings.overlaps && !settings.uneven;
  return HasNoGaps(frame, volume) || (mayHave && (IsFinite(volume) || !TakesGradients(settings)));
}

// True if packets can read one of the volumes of a frame.
bool IsReadByPackets(const Frame& frame, VolumeResources& volume)
{
  return HasPacketRecipe(frame) && AreLevelsPlain(frame, volume) && CanBeIndexed(frame, volume) &&
    IsThickEnough(frame, volume) && HasPlainGaps(frame, volume);
}

}

// Packets keep the light of places from one image to the next, and take it from there. A shader
// marches a ray to each light from each sample, and takes seconds to compile: Decision 0047. A
// bound of the graphics memory is about the device, which then draws whatever it can.
bool ShouldMarchByPackets(const Frame& frame)
{
  const bool isForSoftware = IsSoftwareRasterizer() && frame.device.mostMemoryBytes == 0;
  return isForSoftware || IsInWayOfLights(frame.settings) || IsInWayOfSky(frame.settings);
}

// The voxels are examined last, because that takes time.
bool CanMarchByPackets(const Frame& frame, SceneResources& resources)
{
  const bool may = frame.device.mayMarchOnProcessor && frame.userCode.IsEmpty();
  if (!may || !IsReadByPackets(frame, resources.First()))
  {
    return false;
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    if (!IsReadByPackets(frame.others[i], resources.Other(i)))
    {
      return false;
    }
  }
  return true;
}

}
