// A frame whose rays the processor marches itself, where OpenGL is drawn by it too.

#include "March/RayMarcher.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "March/Processor/SoftwareRasterizer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtk_glew.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace varimarch
{

namespace
{

// Not slices, nor the faces of boxes, nor sums of these, nor extremes of splines.
bool IsBlendedByPackets(const RenderSettings& settings)
{
  const bool isComposite = settings.blend == Blend::Composite;
  const bool isExtreme = IsExtreme(settings.blend);
  const bool isSum = IsProjection(settings.blend) && !isExtreme;
  if (settings.nearest)
  {
    return isComposite || isExtreme;
  }
  return isComposite || isSum || (!settings.cubic && settings.blend != Blend::Slice);
}

// Of mixtures packets have no other rule.
bool MayMixByMidpoints(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool mayChoose = frame.chooseIntegration || settings.overlaps || settings.nearest;
  return settings.blend == Blend::Composite &&
    (mayChoose || settings.integration == Integration::Midpoint);
}

// What packets have no code for is left to shaders, which have all.
bool HasPacketRecipe(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool isPlain = settings.functionOf != FunctionOf::TwoValues;
  const bool isMixed = !IsMixture(frame) || MayMixByMidpoints(frame);
  const bool isMasked = settings.mask != Mask::None;
  const bool isLocated = frame.toImages || Locates(settings.pass);
  const bool hasMask = !isMasked || frame.mask.dimensions == frame.geometry.dimensions;
  const bool isSampledEvenly = !settings.uneven || (!isLocated && !settings.nearest);
  const bool hasPlaces = !isLocated || !IsProjection(settings.blend);
  const bool hasSteps = settings.acceleration != Acceleration::ScalarField;
  const bool hasRule = settings.blend != Blend::Composite || !IsSampled(settings) ||
    MarchesMaterial(settings) || settings.integration == Integration::Midpoint ||
    settings.integration == Integration::PreIntegrated;
  return IsBlendedByPackets(settings) && isPlain && isMixed && isSampledEvenly && hasPlaces &&
    hasMask && !settings.clippedGradients && hasSteps && hasRule && !settings.countFetches;
}

// In 32 bits, to the end of the last that are read together.
bool CanBeIndexed(glm::ivec3 voxels, bool cubic)
{
  const int fewest = cubic ? 4 : 2;
  const double count = double(voxels.x) * voxels.y * voxels.z;
  return voxels.x >= fewest && voxels.y >= fewest && voxels.z >= fewest &&
    count < double(std::numeric_limits<int>::max());
}

// Shaders shift and scale numbers that floats do not hold, or that are large, small or far from
// zero.
bool IsPlain(const ScalarTexels& texels, vtkDataArray* array)
{
  if (texels.normalized)
  {
    constexpr double MostWhole = 1 << 24; // that a float can be
    const bool areFew = std::max(-texels.smallestScalar, texels.largestScalar) <= MostWhole;
    return areFew || PacketVoxelTypeOf(array);
  }
  constexpr double Large = 1e15;
  return texels.mapping.offset == 0.0 && texels.mapping.scale <= Large &&
    texels.mapping.scale >= 1.0 / Large;
}

bool HasPlainValues(const VolumeResources& volume)
{
  const VoxelComponents components = volume.MarchedComponents();
  bool arePlain = true;
  for (std::size_t i = 0; i < components.size() && arePlain; ++i)
  {
    arePlain = IsPlain(volume.Blocks().TexelsOfComponents()[i], components[i].array);
  }
  return arePlain;
}

// Shaders know which gradients gaps take away.
bool HasPlainGaps(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool isFinite = volume.Blocks().Texels().normalized || volume.AreVoxelsFinite();
  const bool takesNoGradients = IsProjection(settings.blend) ||
    (settings.blend == Blend::Composite && !settings.shading && !settings.gradientOpacity &&
      settings.functionOf == FunctionOf::Value);
  const bool hasAny = frame.blanking.Any() || !isFinite;
  const bool mayHave = !settings.overlaps && !settings.uneven;
  return !hasAny || (mayHave && (isFinite || takesNoGradients));
}

// One of the volumes of a picture.
bool IsReadByPackets(const Frame& frame, VolumeResources& volume)
{
  return HasPacketRecipe(frame) && CanBeIndexed(frame.geometry.dimensions, frame.settings.cubic) &&
    HasPlainValues(volume) && HasPlainGaps(frame, volume);
}

// Of pixels of a viewport, those that are drawn.
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

// What Shaders/Marched take of a frame: pictures or places.
std::vector<PacketScene> PartsOf(
  const PacketScene& scene, const Frame& frame, const std::vector<float>& layerDepths)
{
  PacketScene other = scene;
  if (Peels(frame.settings.pass))
  {
    PacketScene front = scene;
    front.cuts.layers = layerDepths.data();
    other.cuts.layers = layerDepths.data() + 2;
    return { front, other };
  }
  if (frame.settings.pass == RayPass::PictureAndDepth)
  {
    other.location = { LeastDepthOpacity, 0.0f, frame.clampDepth };
    other.depths = frame.clampDepth ? PacketDepths() : scene.depths; // rays end behind these
    return { scene, other };
  }
  if (frame.settings.pass == RayPass::PickVoxel)
  {
    other.location = { 0.5f, LeastPickedOpacity, false };
  }
  return { other };
}

// Shaders/Window/WindowLevel.glsl.
void Window(std::vector<float>& rgba, const glm::dvec2& scaleBias)
{
  for (std::size_t i = 0; i < rgba.size(); ++i)
  {
    const float opacity = rgba[i | 3];
    const float color = rgba[i] * float(scaleBias.x) + opacity * float(scaleBias.y);
    rgba[i] = i % 4 == 3 ? opacity : std::clamp(color, 0.0f, opacity);
  }
}

}

// First what needs no look at the voxels.
bool RayMarcher::MarchesPackets(const Frame& frame)
{
  const bool may = frame.mayMarchByProcessor && IsSoftwareRasterizer() &&
    frame.mostMemoryBytes == 0 && frame.userCode.IsEmpty();
  if (!may || !IsReadByPackets(frame, this->volume))
  {
    return false;
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    if (!IsReadByPackets(frame.others[i], *this->others[i]))
    {
      return false;
    }
  }
  return true;
}

PacketSurroundings RayMarcher::SurroundingsOf(const Frame& frame)
{
  PacketSurroundings around = {};
  around.drawnBox = this->drawnBox;
  around.planesGrid = { frame.cuts.planesGrid.begin(), frame.cuts.planesGrid.end() };
  if (frame.settings.sceneGeometry)
  {
    around.depth = this->depth.Depths(frame.window).data();
    around.depthPixels = this->depth.SizePixels();
  }
  if (frame.settings.lights)
  {
    around.lights = LightTexelsOf(frame.renderer);
  }
  if (frame.settings.mask == Mask::Labels)
  {
    around.maskRows = PacketRowsOf(this->volume.OpticalTables());
  }
  if (frame.settings.blend == Blend::Isosurface)
  {
    around.isosurfaces = IsosurfaceEntriesOf(frame);
  }
  if (Peels(frame.settings.pass))
  {
    around.layerDepths = this->DrawLayerDepths(frame);
  }
  around.noise = frame.settings.jitter ? this->picture.noise.Tile().data() : nullptr;
  return around;
}

std::vector<float> RayMarcher::DrawLayerDepths(const Frame& frame)
{
  Frame depths = frame;
  depths.settings.role = ShaderRole::WriteLayerDepths;
  this->UpdateProgram(depths);
  FloatFramebuffer& framebuffer = this->picture.layerDepths;
  framebuffer.Draw(
    frame.window, frame.viewport, [&] { this->DrawBox(depths, this->BoxOfVisible()); });
  return framebuffer.Read(frame.window, frame.viewport);
}

void RayMarcher::DrawPackets(const Frame& frame)
{
  DrawnBlock drawn = this->BoxOfVisible();
  drawn.coverGrid = frame.addsUp ? WithItsEdges(drawn.coverGrid) : drawn.coverGrid;
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  const Viewport pixels = WithinScissors(PixelsOf(drawn.coverGrid, clipFromGrid, frame.viewport),
    frame.viewport, frame.window->GetState());
  if (pixels.width == 0 || pixels.height == 0)
  {
    return;
  }
  SceneOfVolume first(frame, this->volume, this->SurroundingsOf(frame), pixels);
  const MixedScenes mixed = this->MixScenes(first.scene, frame, pixels);
  this->packets.March(frame.window, PartsOf(first.scene, frame, first.around.layerDepths), pixels);
  this->shaderParts.clear();

  Frame marched = frame;
  marched.settings.role = ShaderRole::ShowMarchedImage;
  this->UpdateProgram(marched);
  this->DrawBox(marched, drawn);
}

std::vector<float> RayMarcher::MarchProbe(const Frame& frame)
{
  const Viewport& pixels = frame.viewport;
  std::vector<float> rgba(4 * std::size_t(pixels.width) * pixels.height);
  if (this->IsNothingDrawn())
  {
    return rgba;
  }
  SceneOfVolume first(frame, this->volume, this->SurroundingsOf(frame), pixels);
  const MixedScenes mixed = this->MixScenes(first.scene, frame, pixels);
  MarchPackets(first.scene, pixels, rgba.data());
  if (frame.settings.windowLevel)
  {
    Window(rgba, frame.windowScaleBias);
  }
  return rgba;
}

}
