// A frame whose rays the processor marches itself, where OpenGL is drawn by it too.

#include "RayMarcher.h"

#include "BoxInView.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/ShaderRecipe.h"
#include "SoftwareRasterizer.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"
#include "vtk_glew.h"

#include <glm/gtc/matrix_access.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace varimarch
{

namespace
{

std::optional<VoxelType> VoxelTypeOf(const VoxelChannels& channels)
{
  vtkDataArray* const array = channels.front().array;
  if (array->GetNumberOfComponents() != 1)
  {
    return std::nullopt;
  }
  switch (array->GetDataType())
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return VoxelType::Int8;
    case VTK_UNSIGNED_CHAR:
      return VoxelType::UInt8;
    case VTK_SHORT:
      return VoxelType::Int16;
    case VTK_UNSIGNED_SHORT:
      return VoxelType::UInt16;
    case VTK_FLOAT:
      return VoxelType::Float32;
  }
  return std::nullopt;
}

// What packets have no code for is left to shaders, which have all.
bool HasPacketRecipe(const RenderSettings& settings)
{
  const bool isBlended = settings.blend == Blend::Composite || IsExtreme(settings.blend) ||
    settings.blend == Blend::Isosurface;
  const bool isPlain = settings.components == Components::One &&
    settings.functionOf == FunctionOf::Value && settings.mask == Mask::None && !settings.nearest &&
    !settings.cubic && !settings.uneven;
  const bool isCutByPlanes = !settings.cropping && !settings.clippedGradients;
  const bool hasSteps = settings.acceleration != Acceleration::ScalarField;
  const bool hasRule = settings.blend != Blend::Composite || MarchesMaterial(settings) ||
    settings.integration == Integration::Midpoint ||
    settings.integration == Integration::PreIntegrated;
  return isBlended && isPlain && isCutByPlanes && hasSteps && hasRule && !settings.overlaps &&
    !settings.countFetches && settings.pass == RayPass::Whole;
}

// In 32 bits, to the end of the last pair.
bool CanBeIndexed(glm::ivec3 voxels)
{
  const double count = double(voxels.x) * voxels.y * voxels.z;
  return voxels.x >= 2 && voxels.y >= 2 && voxels.z >= 2 &&
    count < double(std::numeric_limits<int>::max());
}

bool AreFinite(vtkDataArray* array)
{
  const float* const voxels = static_cast<const float*>(array->GetVoidPointer(0));
  std::atomic<bool> finite = true;
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, array->GetNumberOfValues(), 1 << 16),
    [&](const tbb::blocked_range<vtkIdType>& part)
    {
      const bool isFinite = std::all_of(voxels + part.begin(), voxels + part.end(),
        [](float voxel) { return std::isfinite(voxel); });
      finite = finite && isFinite;
    });
  return finite;
}

PacketCamera CameraOf(const Frame& frame, const PixelRays& rays, const Box& boxGrid)
{
  PacketCamera camera = {};
  for (int i = 0; i < 3; ++i)
  {
    camera.startGrid[i] = rays.startGrid[i];
    camera.directionGrid[i] = rays.directionGrid[i];
  }
  camera.nearPlaneGrid = rays.nearPlaneGrid;
  camera.farPlaneGrid = rays.farPlaneGrid;
  camera.worldFromGrid = frame.geometry.WorldFromGridDirection();
  camera.boxLowerGrid = boxGrid.lower;
  camera.boxUpperGrid = boxGrid.upper;
  camera.pictureWidth = frame.viewport.width;
  camera.pictureHeight = frame.viewport.height;
  camera.rayOffsetPixels = frame.rayOffsetPixels;
  return camera;
}

PacketShading ShadingOf(const RenderSettings& settings)
{
  if (!settings.shading)
  {
    return PacketShading::None;
  }
  return settings.lights ? PacketShading::Lights : PacketShading::HeadLight;
}

// Normals in texels, as shaders have them: products of those in units of the data could overflow.
PacketLight LightOf(const Frame& frame, const LightTexels& others, double scalarPerTexel)
{
  PacketLight light = {};
  light.shading = ShadingOf(frame.settings);
  if (light.shading == PacketShading::None)
  {
    return light;
  }
  const HeadLightColors atEye = HeadLightColorsOf(frame.renderer);
  light.worldFromGradient = frame.geometry.WorldFromGridNormal() / scalarPerTexel;
  light.reflectance = ReflectanceOf(frame.property, 0);
  light.diffuse = atEye.diffuse;
  light.specular = atEye.specular;
  light.damps = frame.settings.damping;
  if (light.damps)
  {
    light.dampingFactors = frame.geometry.gradientFactors / frame.dampingGradient;
  }
  if (light.shading == PacketShading::Lights)
  {
    light.ambient = AmbientLightOf(frame.renderer);
    light.backsLit = frame.renderer->GetTwoSidedLighting() ? 1.0f : 0.0f;
    light.worldOfGridOrigin = glm::dvec3(frame.geometry.worldFromGrid[3]);
    light.texels = others.texels.data();
    light.distantCount = others.distantCount;
    light.nearCount = others.nearCount;
  }
  return light;
}

PacketRule RuleOf(const RenderSettings& settings)
{
  if (IsExtreme(settings.blend))
  {
    return PacketRule::Extreme;
  }
  if (settings.blend == Blend::Isosurface)
  {
    return PacketRule::Isosurfaces;
  }
  const bool isMidpoint = settings.integration == Integration::Midpoint;
  return MarchesMaterial(settings)
    ? (isMidpoint ? PacketRule::MaterialMidpoint : PacketRule::MaterialLinear)
    : (isMidpoint ? PacketRule::Midpoint : PacketRule::PreIntegrated);
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

}

// Shaders know where gaps are, and shift and scale floats that are large, small or far from zero.
bool RayMarcher::HasPlainValues(const Frame& frame)
{
  const ScalarTexels& texels = this->blocks.Texels();
  if (frame.blanking.Any() || texels.normalized)
  {
    return !frame.blanking.Any();
  }
  constexpr double Large = 1e15;
  if (texels.mapping.offset != 0.0 || texels.mapping.scale > Large ||
    texels.mapping.scale < 1.0 / Large)
  {
    return false;
  }
  if (!this->voxelsAreFinite)
  {
    this->voxelsAreFinite = AreFinite(frame.channels.front().array);
  }
  return *this->voxelsAreFinite;
}

bool RayMarcher::MarchesPackets(const Frame& frame)
{
  return frame.mayMarchByProcessor && CanMarchPackets() && IsSoftwareRasterizer() &&
    HasPacketRecipe(frame.settings) && !frame.toImages && frame.mostMemoryBytes == 0 &&
    frame.userCode.IsEmpty() && VoxelTypeOf(frame.channels) &&
    CanBeIndexed(frame.geometry.dimensions) && this->HasPlainValues(frame);
}

PacketLook RayMarcher::LookOfPackets(const Frame& frame) const
{
  const OpticalTable& table = this->opticalTable.Table();
  const bool preIntegrated = UsesPreIntegration(frame.settings);
  const std::vector<glm::vec4>& entries =
    preIntegrated ? this->preIntegratedTable.Kept().entries : table.entries;
  const int last =
    preIntegrated ? this->preIntegratedTable.Kept().size - 1 : int(entries.size()) - 1;
  const double extent = table.lastValue - table.firstValue;
  const double indexPerValue = extent > 0.0 ? last / extent : 0.0;
  const std::array<double, 2>& visible = this->opticalTable.VisibleValues();
  return { entries.data(), last, float(indexPerValue), float(-table.firstValue * indexPerValue),
    table.entries.front(), table.entries.back(), glm::vec2(visible[0], visible[1]) };
}

PacketSteps RayMarcher::StepsOfPackets(const Frame& frame) const
{
  PacketSteps steps = {};
  steps.stepMm = float(frame.sampleDistanceMm);
  steps.mostSegments = MostSegmentsOf(frame);
  steps.mostOpticalDepth = float(-std::log(frame.earlyTerminationTransmittance));
  steps.grow = frame.settings.acceleration == Acceleration::OpticalField;
  steps.brickCount = glm::ivec3(1);
  steps.cellsPerBrick = float(BrickRanges::CellsPerSide);
  if (steps.grow && frame.settings.skipsBricks)
  {
    steps.bricks = this->field.Bricks().data();
    steps.brickCount = this->field.Size();
  }
  if (frame.settings.jitter)
  {
    steps.noise = this->picture.noise.Tile().data();
    steps.noiseMask = BlueNoiseTexture::Pixels - 1;
  }
  return steps;
}

PacketGradientOpacity RayMarcher::GradientOpacityOfPackets(const Frame& frame) const
{
  PacketGradientOpacity opacity = {};
  if (frame.settings.gradientOpacity)
  {
    opacity.factors = this->gradientOpacityEntries.data();
    opacity.lastIndex = int(this->gradientOpacityEntries.size()) - 1;
    opacity.indicesPerGradient =
      frame.geometry.gradientFactors * (opacity.lastIndex / LargestGradient(this->blocks.Texels()));
    opacity.unitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  }
  return opacity;
}

PacketExtreme RayMarcher::ExtremeOfPackets(const Frame& frame) const
{
  PacketExtreme extreme = {};
  if (!IsExtreme(frame.settings.blend))
  {
    return extreme;
  }
  const bool isMaximum = frame.settings.blend == Blend::MaximumIntensity;
  const ScalarTexels& texels = this->blocks.Texels();
  extreme.sense = isMaximum ? 1.0f : -1.0f;
  extreme.best = float(isMaximum ? texels.largestValue : -texels.smallestValue);
  extreme.opacityUnitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  extreme.brickCount = glm::ivec3(1);
  if (frame.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeSteps steps = this->ExtremeStepsOf(frame.settings.blend);
    extreme.bricks = this->field.Extremes().data();
    extreme.brickCount = this->field.Size();
    extreme.bestOfFirstStep = float(steps.sense * steps.firstValue);
    extreme.bestPerStep = float(steps.sense * steps.valuePerStep);
  }
  return extreme;
}

PacketScene RayMarcher::SceneOfPackets(const Frame& frame, const PacketArrays& arrays) const
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  PacketScene scene = {};
  scene.camera = CameraOf(frame, ComputePixelRays(clipFromGrid, this->drawnBox), this->drawnBox);
  scene.volume = { frame.channels.front().array->GetVoidPointer(0), *VoxelTypeOf(frame.channels),
    frame.geometry.dimensions };
  scene.look = this->LookOfPackets(frame);
  scene.light = LightOf(frame, arrays.lights, this->blocks.Texels().mapping.scale);
  scene.gradientOpacity = this->GradientOpacityOfPackets(frame);
  scene.extreme = this->ExtremeOfPackets(frame);
  scene.isosurfaces = { arrays.isosurfaces.data(), int(arrays.isosurfaces.size() / 2) };
  scene.steps = this->StepsOfPackets(frame);
  scene.cuts.planesGrid = arrays.planesGrid.data();
  scene.cuts.planeCount = int(arrays.planesGrid.size());
  if (!arrays.depth.empty())
  {
    scene.cuts.depth = arrays.depth.data();
    scene.cuts.depthPixels =
      glm::ivec2(this->depth.Texture()->GetWidth(), this->depth.Texture()->GetHeight());
    scene.cuts.depthPixelsPerPixel =
      glm::dvec2(scene.cuts.depthPixels) / glm::dvec2(frame.viewport.width, frame.viewport.height);
    scene.cuts.clipDepthRow = glm::row(clipFromGrid, 2);
    scene.cuts.clipWeightRow = glm::row(clipFromGrid, 3);
  }
  scene.rule = RuleOf(frame.settings);
  return scene;
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
  const PacketArrays arrays{ { frame.cuts.planesGrid.begin(), frame.cuts.planesGrid.end() },
    frame.settings.sceneGeometry ? this->depth.Read(frame.window) : std::vector<float>(),
    frame.settings.lights ? LightTexelsOf(frame.renderer) : LightTexels(),
    frame.settings.blend == Blend::Isosurface ? IsosurfaceEntriesOf(frame)
                                              : std::vector<glm::vec4>() };
  PacketScene scene = this->SceneOfPackets(frame, arrays);
  std::optional<VisibleDepths> visible;
  if (scene.steps.bricks)
  {
    visible.emplace(this->field.VisibleBlocks(), clipFromGrid, scene.camera, pixels);
    scene.depths = visible->Depths();
  }
  this->packets.March(frame.window, scene, pixels);
  this->shaderParts.clear();

  Frame marched = frame;
  marched.settings.pass = RayPass::Marched;
  this->UpdateProgram(marched);
  this->DrawBox(marched, drawn);
}

void RayMarcher::SetMarchedUniforms(const Frame& frame, const glm::dmat4& clipFromGrid)
{
  this->packets.Texture()->Activate();
  this->program.Set("marchedTexture", this->packets.Texture());
  this->program.Set("marchedColumns", this->packets.Pixels().width);
  this->program.Set("viewportOriginPixels",
    glm::dvec2(frame.viewport.left + this->packets.Pixels().left,
      frame.viewport.bottom + this->packets.Pixels().bottom));
  this->program.Set("clipFromGrid", clipFromGrid);
  if (frame.settings.windowLevel)
  {
    this->program.Set("windowScaleBias", frame.windowScaleBias);
  }
}

}
