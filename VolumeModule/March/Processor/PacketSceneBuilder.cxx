// Builds the scene of a frame as plain numbers, which packets of rays read.

#include "March/Processor/PacketSceneBuilder.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/RayParametersBuilder.h"
#include "March/VolumeParametersBuilder.h"
#include "Readers/VoxelLayout.h"
#include "Resources/ValueFocus.h"

#include "vtkDataArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace varimarch
{

namespace
{

PacketShading ShadingOf(const RenderSettings& settings)
{
  if (!settings.shading)
  {
    return PacketShading::None;
  }
  return settings.lights ? PacketShading::Lights : PacketShading::HeadLight;
}

PacketRule RuleOf(const RenderSettings& settings)
{
  if (IsExtreme(settings.blend))
  {
    return settings.nearest ? PacketRule::ExtremeVoxel : PacketRule::Extreme;
  }
  if (IsProjection(settings.blend))
  {
    return settings.limitsMean ? PacketRule::RangeMean : PacketRule::Projection;
  }
  if (settings.blend == Blend::Isosurface)
  {
    return PacketRule::Isosurfaces;
  }
  if (settings.nearest)
  {
    return MarchesMaterial(settings) ? PacketRule::MaterialVoxels : PacketRule::Voxels;
  }
  const bool isMidpoint = settings.integration == Integration::Midpoint;
  return MarchesMaterial(settings)
    ? (isMidpoint ? PacketRule::MaterialMidpoint : PacketRule::MaterialLinear)
    : (isMidpoint ? PacketRule::Midpoint : PacketRule::PreIntegrated);
}

// True if rays take the samples of a march of the whole volume: where rays are sampled, and neither
// divided into pieces of their own nor dimmed by light that is gathered along them.
bool SharesSamples(const VolumeMarch& march)
{
  const RenderSettings& settings = march.settings;
  const bool isPlain = settings.blend == Blend::Composite && settings.pass == RayPass::Whole &&
    IsSampled(settings) && !settings.shadows && !settings.occlusion && !IsMixture(march.frame);
  const bool isInPieces = settings.cropping || settings.gaps || settings.mask != Mask::None ||
    march.frame.blockLevels != nullptr;
  return march.plan.wholeData && isPlain && !isInPieces;
}

PacketSteps StepsOf(const VolumeMarch& march, const VolumeResources& volume)
{
  PacketSteps steps = {};
  // A part that ends early lets another one behind it shine through.
  constexpr double MostThroughPart = 1e-5;
  const double end = march.frame.quality.earlyTerminationTransmittance;
  steps.areShared = SharesSamples(march);
  steps.mostOpticalDepth = float(-std::log(steps.areShared ? std::min(end, MostThroughPart) : end));
  steps.grow = march.settings.acceleration == Acceleration::OpticalField;
  steps.brickCount = glm::ivec3(1);
  if (steps.grow && march.settings.skipsBricks)
  {
    steps.bricks = volume.Fields().OfBricks().Bricks().data();
    steps.brickCount = volume.Fields().OfBricks().Size();
  }
  return steps;
}

PacketExtreme ExtremeOf(const VolumeMarch& march, const VolumeResources& volume)
{
  PacketExtreme extreme = {};
  if (!IsExtreme(march.settings.blend))
  {
    return extreme;
  }
  extreme.brickCount = glm::ivec3(1);
  if (march.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeBlocks& blocks = volume.Fields().OfBricks().ExtremeBlocks();
    extreme.blocks = blocks.steps.data();
    extreme.blockCount = blocks.count;
    extreme.bricksPerBlock = float(ExtremeBlocks::BricksPerSide);
    extreme.bricks = volume.Fields().OfBricks().Extremes().data();
    extreme.brickCount = volume.Fields().OfBricks().Size();
  }
  return extreme;
}

// Opacity is a function of values alone, which are interpolated linearly on an even grid.
bool EndsAtOpaqueValues(const VolumeMarch& march)
{
  const RenderSettings& settings = march.settings;
  const bool isOfValues = settings.blend == Blend::Composite && IsSampled(settings) &&
    settings.components == Components::One && settings.functionOf == FunctionOf::Value;
  const bool isPlain = !settings.gradientOpacity && !settings.cubic && !settings.uneven;
  return isOfValues && isPlain && settings.mask != Mask::Labels && !IsMixture(march.frame);
}

PacketOpaque OpaqueOf(const VolumeMarch& march, const VolumeResources& volume)
{
  PacketOpaque opaque = {};
  if (!EndsAtOpaqueValues(march))
  {
    return opaque;
  }
  constexpr double Most = std::numeric_limits<float>::max();
  const OpticalTable& table = volume.Materials().OpticalTables().Table();
  opaque.entry = float((table.lastValue - table.firstValue) / double(table.entries.size() - 1));
  for (const ValueRange& range : OpaqueValuesOf(march.frame, volume.Blocks().Texels()))
  {
    if (opaque.count < PacketOpaque::MostRanges && range.upper - range.lower > 2.0 * opaque.entry)
    {
      opaque.ranges[opaque.count++] = glm::clamp(glm::dvec2(range.lower, range.upper), -Most, Most);
    }
  }
  return opaque;
}

PacketCuts CutsOf(const VolumeMarch& march, const PacketSurroundings& around)
{
  PacketCuts cuts = {};
  cuts.limitsSpan = march.settings.limitsSpan;
  cuts.depthPixels = around.depthPixels;
  cuts.layerPixels = { march.plan.viewport.width, march.plan.viewport.height };
  return cuts;
}

// The entries of the table that values are looked up in.
const glm::vec4* EntriesOf(
  const VolumeMarch& march, const VolumeResources& volume, std::size_t table)
{
  return UsesPreIntegration(march.settings)
    ? volume.Materials().PreIntegrated().Kept().entries.data()
    : volume.Materials().OpticalTables().Tables()[table].entries.data();
}

}

PacketLook LookOf(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeParameters& parameters, std::size_t table, int component)
{
  PacketLook look = LookBy(parameters, EntriesOf(march, volume, table), int(table), component);
  look.sums = UsesPreIntegration(march.settings) ? nullptr : volume.Light().ExtinctionSumsOf(table);
  return look;
}

std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables, const TexelMapping& mapping)
{
  std::vector<PacketRow> rows;
  for (const OpticalTable& table : tables.Tables())
  {
    const IndexInTable index =
      IndexOf(table, double(table.entries.size() - 1), mapping.scale, mapping.offset);
    rows.push_back({ table.entries.data(), int(table.entries.size()) - 1, float(index.scale),
      float(index.bias) });
  }
  return rows;
}

PacketScene PacketSceneOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketSurroundings& around)
{
  PacketScene scene = {};
  // Pixel coordinates begin at the first pixel of the frame.
  scene.rays = RayParametersOf(march, around.drawnBox);
  scene.rays.viewportOriginPixels = -march.plan.rayOffsetPixels;
  scene.rayTextures = around.textures;
  scene.parameters = VolumeParametersOf(march, volume, VolumeOfProcessor(volume));
  scene.textures = volume.Textures(march.settings, nullptr);
  vtkDataArray* const voxels = volume.Packets().Voxels();
  scene.volume = { voxels->GetVoidPointer(0), *VoxelTypeOf(voxels->GetDataType()),
    march.settings.cubic, volume.Packets().VoxelCount() };
  scene.look = LookOf(march, volume, scene.parameters, 0, 0);
  scene.labelRows = around.labelRows.empty() ? nullptr : around.labelRows.data();
  scene.light = { ShadingOf(march.settings), march.settings.damping, march.settings.labelSurfaces,
    march.settings.shading && march.settings.shadows, march.settings.scattering };
  scene.shadows = volume.Light().Shadows(march, 0);
  scene.sky = volume.Light().Sky(march);
  scene.extreme = ExtremeOf(march, volume);
  scene.opaque = OpaqueOf(march, volume);
  scene.isMean = march.settings.blend == Blend::AverageIntensity;
  scene.steps = StepsOf(march, volume);
  scene.cuts = CutsOf(march, around);
  if (around.textures.depthTexture)
  {
    scene.rays.depthPixelsPerPixel = glm::dvec2(around.depthPixels) /
      glm::dvec2(march.plan.viewport.width, march.plan.viewport.height);
  }
  scene.rule = RuleOf(march.settings);
  return scene;
}

// The depths of visible bricks bound the rays, with two exceptions: in projections invisible parts
// count too, and filled gaps are visible but not recorded in bricks.
SceneOfVolume::SceneOfVolume(const VolumeMarch& march, VolumeResources& volume,
  PacketSurroundings newAround, const Viewport& pixels)
  : around(std::move(newAround))
  , scene(PacketSceneOf(march, volume, this->around))
{
  const bool isOfBricks =
    this->scene.rule != PacketRule::Projection && this->scene.parameters.gapOptical.a == 0.0f;
  if (this->scene.steps.bricks && isOfBricks)
  {
    const glm::dmat4 clipFromGrid = march.frame.ClipFromGrid();
    this->scene.depths =
      volume.Fields().OfBricks().VisibleDepthsIn(clipFromGrid, this->scene.rays.rayDirectionGrid[0],
        { march.plan.viewport.width, march.plan.viewport.height }, pixels);
  }
}

namespace
{

// Moves the depths of visible parts from the rays to the volume: rays through several volumes are
// not bounded by the visible parts of one.
void TakeDepths(PacketScene& scene)
{
  scene.constituent.visible = scene.depths;
  scene.depths = {};
}

PacketSurroundings SurroundingsOfOther(const Frame& frame, const VolumeResources& volume)
{
  PacketSurroundings around = {};
  around.drawnBox = frame.geometry.boxGrid;
  around.textures.clippingPlanes = volume.ClippingPlanes();
  return around;
}

}

PacketScenes::PacketScenes(const VolumeMarch& march, SceneResources& resources,
  PacketSurroundings around, const Viewport& pixels)
  : first(march, resources.First(), std::move(around), pixels)
{
  if (IsMixture(march.frame))
  {
    this->Mix(march, resources, pixels);
  }
  else if (march.frame.blockLevels)
  {
    this->AddCoarser(march, resources, pixels);
  }
}

// Rays are bounded by the parts of the voxels that are visible, not by those of the levels.
void PacketScenes::AddCoarser(
  const VolumeMarch& march, SceneResources& resources, const Viewport& pixels)
{
  this->levels = { &this->first.scene };
  for (std::size_t i = 0; i < march.frame.coarser.size(); ++i)
  {
    const VolumeMarch level = MarchOfCoarser(march.frame, march.plan, i);
    VolumeResources& volume = resources.Coarser(i);
    PacketSurroundings around = SurroundingsOfOther(level.frame, volume);
    around.textures.noiseTexture = this->first.around.textures.noiseTexture;
    around.textures.casterTree = this->first.around.textures.casterTree;
    PacketScene& scene = this->coarser.emplace_back(level, volume, std::move(around), pixels).scene;
    scene.depths = {};
    scene.parameters.ownGridFromRays = GridFromGrid(level.frame.geometry, march.frame.geometry);
    scene.levels.voxelGridFromOwn = GridFromGrid(march.frame.geometry, level.frame.geometry);
    this->levels.push_back(&scene);
  }
  const BlockLevels& blocks = *march.frame.blockLevels;
  const PacketLevels all = { this->levels.data(), int(this->levels.size()), glm::mat4(1.0f),
    blocks.ofBlocks.data(), blocks.count, float(blocks.side) };
  this->first.scene.levels = all;
  for (SceneOfVolume& level : this->coarser)
  {
    const glm::mat4 voxelGridFromOwn = level.scene.levels.voxelGridFromOwn;
    level.scene.levels = all;
    level.scene.levels.voxelGridFromOwn = voxelGridFromOwn;
  }
}

void PacketScenes::Mix(const VolumeMarch& march, SceneResources& resources, const Viewport& pixels)
{
  const Frame& frame = march.frame;
  std::vector<PacketScene> own = ConstituentsOf(march, resources.First(), this->first.scene);
  for (PacketScene& scene : own)
  {
    if (!frame.others.empty())
    {
      TakeDepths(scene);
    }
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    const VolumeMarch other = MarchOfOther(frame, march.plan, i);
    VolumeResources& volume = resources.Other(i);
    this->others.emplace_back(other, volume, SurroundingsOfOther(other.frame, volume), pixels);
    for (PacketScene& scene : ConstituentsOf(other, volume, this->others.back().scene))
    {
      scene.parameters.ownGridFromRays = GridFromGrid(other.frame.geometry, frame.geometry);
      TakeDepths(scene);
      this->mixed.push_back(scene);
    }
  }
  this->mixed.insert(this->mixed.end(), own.begin() + 1, own.end());
  const auto castsShadows = [](const PacketScene& scene) { return scene.light.castsShadows; };
  const bool isInShadow = std::any_of(this->mixed.begin(), this->mixed.end(), castsShadows);
  this->first.scene = own.front();
  this->first.scene.light.castsShadows |= isInShadow;
  this->first.scene.constituent.others = this->mixed.data();
  this->first.scene.constituent.otherCount = int(this->mixed.size());
}

namespace
{

// The colours of dependent components. The last component has the opacity.
PacketColors ColorsOf(
  const VolumeMarch& march, const VolumeResources& volume, const VolumeParameters& parameters)
{
  PacketColors colors = {};
  if (march.settings.components == Components::LuminanceOpacity)
  {
    colors.count = 1;
    colors.look = LookOf(march, volume, parameters, 0, 0);
  }
  else if (march.settings.components == Components::Rgba)
  {
    colors.count = 3;
  }
  for (int component = 0; component < colors.count; ++component)
  {
    colors.voxels[component] = volume.Packets().Voxels(component)->GetVoidPointer(0);
  }
  return colors;
}

// The index of the table that has a part's opacities.
std::size_t OpacityTableOf(const VolumeResources& volume, int component)
{
  const std::vector<MaterialFunction>& tables = volume.Materials().MaterialTables();
  const auto decides = [&](const MaterialFunction& table)
  { return table.decidesOnOpacity && table.component == component; };
  return std::size_t(std::find_if(tables.begin(), tables.end(), decides) - tables.begin());
}

}

bool IsMixture(const Frame& frame)
{
  return !frame.others.empty() || frame.settings.uneven ||
    frame.settings.components != Components::One;
}

std::vector<PacketScene> ConstituentsOf(
  const VolumeMarch& march, const VolumeResources& volume, const PacketScene& scene)
{
  std::vector<PacketScene> constituents;
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    const int component = OpacityComponentOf(march.settings, part);
    PacketScene one = scene;
    one.volume.voxels = volume.Packets().Voxels(component)->GetVoidPointer(0);
    if (march.settings.functionOf == FunctionOf::Value)
    {
      one.look =
        LookOf(march, volume, scene.parameters, OpacityTableOf(volume, component), component);
    }
    one.colors = ColorsOf(march, volume, scene.parameters);
    one.shadows = volume.Light().Shadows(march, part);
    one.constituent.isOfMixture = true;
    one.constituent.component = part;
    one.constituent.isOfSameBricks = part > 0;
    constituents.push_back(one);
  }
  return constituents;
}

}
