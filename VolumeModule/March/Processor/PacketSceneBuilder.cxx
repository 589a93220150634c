// A frame in plain numbers, as packets of rays are marched by it.

#include "March/Processor/PacketSceneBuilder.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "March/RayParametersBuilder.h"
#include "March/VolumeParametersBuilder.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
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
    return PacketRule::Projection;
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

PacketTwoValues TwoValuesOf(const Frame& frame, const VolumeResources& volume)
{
  const bool isOfGradients = frame.settings.functionOf == FunctionOf::ValueAndGradient;
  return { isOfGradients ? volume.TwoValues().Entries().data() : nullptr, volume.TwoValuesSize() };
}

PacketMask MaskOf(
  const Frame& frame, const VolumeResources& volume, const std::vector<PacketRow>& rows)
{
  PacketMask mask = {};
  if (frame.settings.mask != Mask::None)
  {
    mask.texels = volume.Mask().Texels().data();
    mask.isBinary = frame.settings.mask == Mask::Binary;
  }
  if (frame.settings.mask == Mask::Labels)
  {
    mask.rows = rows.data();
  }
  return mask;
}

PacketGaps GapsOf(const Frame& frame, const VolumeResources& volume)
{
  PacketGaps gaps = {};
  if (frame.settings.gaps)
  {
    gaps.texels = volume.PacketGaps().texels.data();
    gaps.count = volume.PacketGaps().count;
  }
  return gaps;
}

PacketSteps StepsOf(const Frame& frame, const VolumeResources& volume)
{
  PacketSteps steps = {};
  steps.mostOpticalDepth = float(-std::log(frame.earlyTerminationTransmittance));
  steps.grow = frame.settings.acceleration == Acceleration::OpticalField;
  steps.brickCount = glm::ivec3(1);
  if (steps.grow && frame.settings.skipsBricks)
  {
    steps.bricks = volume.Field().Bricks().data();
    steps.brickCount = volume.Field().Size();
  }
  return steps;
}

PacketExtreme ExtremeOf(const Frame& frame, const VolumeResources& volume)
{
  PacketExtreme extreme = {};
  if (!IsExtreme(frame.settings.blend))
  {
    return extreme;
  }
  extreme.brickCount = glm::ivec3(1);
  if (frame.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeBlocks& blocks = volume.Field().ExtremeBlocks();
    extreme.blocks = blocks.steps.data();
    extreme.blockCount = blocks.count;
    extreme.bricksPerBlock = float(ExtremeBlocks::BricksPerSide);
    extreme.bricks = volume.Field().Extremes().data();
    extreme.brickCount = volume.Field().Size();
  }
  return extreme;
}

PacketCuts CutsOf(const Frame& frame, const PacketSurroundings& around)
{
  PacketCuts cuts = {};
  cuts.crops = frame.settings.cropping;
  cuts.planesGrid = around.planesGrid.data();
  cuts.depth = around.depth;
  cuts.depthPixels = around.depthPixels;
  cuts.layerPixels = { frame.viewport.width, frame.viewport.height };
  return cuts;
}

// The entries of the table that values are looked up in.
const glm::vec4* EntriesOf(const Frame& frame, const VolumeResources& volume, std::size_t table)
{
  return UsesPreIntegration(frame.settings) ? volume.PreIntegrated().Kept().entries.data()
                                            : volume.OpticalTables().Tables()[table].entries.data();
}

}

PacketLook LookOf(const Frame& frame, const VolumeResources& volume,
  const VolumeParameters& parameters, std::size_t table, int component)
{
  return LookBy(parameters, EntriesOf(frame, volume, table), int(table), component);
}

std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables)
{
  std::vector<PacketRow> rows;
  for (const OpticalTable& table : tables.Tables())
  {
    const IndexInTable index = IndexOf(table, double(table.entries.size() - 1));
    rows.push_back({ table.entries.data(), int(table.entries.size()) - 1, float(index.scale),
      float(index.bias) });
  }
  return rows;
}

PacketScene PacketSceneOf(
  const Frame& frame, const VolumeResources& volume, const PacketSurroundings& around)
{
  PacketScene scene = {};
  // Pixels are counted from the first of the frame.
  scene.rays = RayParametersOf(frame, around.drawnBox);
  scene.rays.viewportOriginPixels = -frame.rayOffsetPixels;
  scene.parameters = VolumeParametersOf(frame, volume, VolumeOfProcessor(frame, volume));
  vtkDataArray* const voxels = volume.PacketVoxels();
  scene.volume = { voxels->GetVoidPointer(0), *PacketVoxelTypeOf(voxels), frame.settings.cubic,
    frame.geometry.dimensions };
  scene.look = LookOf(frame, volume, scene.parameters, 0, 0);
  scene.twoValues = TwoValuesOf(frame, volume);
  scene.light = { ShadingOf(frame.settings), frame.settings.damping, around.lights.texels.data() };
  scene.gradientOpacity.factors =
    frame.settings.gradientOpacity ? volume.GradientOpacity().Entries().data() : nullptr;
  scene.mask = MaskOf(frame, volume, around.maskRows);
  scene.gaps = GapsOf(frame, volume);
  scene.extreme = ExtremeOf(frame, volume);
  scene.isosurfaces = around.isosurfaces.data();
  scene.isMean = frame.settings.blend == Blend::AverageIntensity;
  scene.steps = StepsOf(frame, volume);
  scene.steps.noise = around.noise;
  scene.cuts = CutsOf(frame, around);
  if (around.depth)
  {
    scene.rays.depthPixelsPerPixel =
      glm::dvec2(around.depthPixels) / glm::dvec2(frame.viewport.width, frame.viewport.height);
  }
  scene.rule = RuleOf(frame.settings);
  return scene;
}

// Of projections what is invisible counts too, and what fills gaps is no brick's.
SceneOfVolume::SceneOfVolume(
  const Frame& frame, VolumeResources& volume, PacketSurroundings newAround, const Viewport& pixels)
  : around(std::move(newAround))
  , scene(PacketSceneOf(frame, volume, this->around))
{
  const bool isOfBricks =
    this->scene.rule != PacketRule::Projection && this->scene.parameters.gapOptical.a == 0.0f;
  if (this->scene.steps.bricks && isOfBricks)
  {
    const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
    this->scene.depths =
      volume.Field().VisibleDepthsIn(clipFromGrid, this->scene.rays.rayDirectionGrid[0],
        { frame.viewport.width, frame.viewport.height }, pixels);
  }
}

}
