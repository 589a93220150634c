// A frame in plain numbers, as packets of rays are marched by it.

#include "March/Processor/PacketSceneBuilder.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/OverlappingVolumes.h"
#include "Resources/BlueNoiseTexture.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace varimarch
{

namespace
{

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
  PacketTwoValues look = {};
  if (frame.settings.functionOf == FunctionOf::ValueAndGradient)
  {
    const ScalarTexels& texels = volume.Blocks().Texels();
    const double range = texels.largestScalar - texels.smallestScalar;
    const double placePerValue = range > 0.0 ? 1.0 / range : 0.0;
    look.entries = volume.TwoValues().Entries().data();
    look.size = volume.TwoValuesSize();
    look.placeScale = float(placePerValue);
    look.placeOffset = float(-texels.smallestScalar * placePerValue);
    look.placesPerGradient = frame.geometry.gradientFactors / LargestGradient(texels);
    look.unitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  }
  return look;
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
    mask.rowPart = float(frame.labelPart);
    mask.unitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
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
    gaps.firstGrid = frame.blanking.IsOfVoxels() ? -0.5f : 0.0f;
    gaps.gapOptical = FillsGaps(frame.settings) ? glm::vec4(frame.gapOptical) : glm::vec4(0.0f);
  }
  return gaps;
}

PacketSteps StepsOf(const Frame& frame, const VolumeResources& volume)
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
  const bool isMaximum = frame.settings.blend == Blend::MaximumIntensity;
  const ScalarTexels& texels = volume.Blocks().Texels();
  extreme.sense = isMaximum ? 1.0f : -1.0f;
  extreme.best = float(isMaximum ? texels.largestValue : -texels.smallestValue);
  extreme.opacityUnitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  extreme.brickCount = glm::ivec3(1);
  if (frame.settings.acceleration == Acceleration::OpticalField)
  {
    const ExtremeSteps steps = volume.ExtremeStepsOf(frame.settings.blend);
    const ExtremeBlocks& blocks = volume.Field().ExtremeBlocks();
    extreme.blocks = blocks.steps.data();
    extreme.blockCount = blocks.count;
    extreme.bricksPerBlock = float(ExtremeBlocks::BricksPerSide);
    extreme.bricks = volume.Field().Extremes().data();
    extreme.brickCount = volume.Field().Size();
    extreme.bestOfFirstStep = float(steps.sense * steps.firstValue);
    extreme.bestPerStep = float(steps.sense * steps.valuePerStep);
  }
  return extreme;
}

PacketProjection ProjectionOf(const Frame& frame, const VolumeResources& volume)
{
  const ScalarTexels& texels = volume.Blocks().Texels();
  const double range = texels.largestScalar - texels.smallestScalar;
  PacketProjection projection = {};
  projection.isMean = frame.settings.blend == Blend::AverageIntensity;
  projection.smallestValue = float(texels.smallestScalar);
  projection.grayPerValue = float(range > 0.0 ? 1.0 / range : 0.0);
  projection.opacityUnitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  constexpr float Any = std::numeric_limits<float>::max();
  projection.countedValues = projection.isMean
    ? glm::clamp(
        glm::dvec2(frame.averagedRange[0], frame.averagedRange[1]), -double(Any), double(Any))
    : glm::dvec2(-Any, Any);
  projection.mostIntegral = projection.isMean ? Any : projection.opacityUnitDistanceMm;
  return projection;
}

}

PacketLook LookOf(const Frame& frame, const VolumeResources& volume, std::size_t tableIndex)
{
  const OpticalTableTexture& tables = volume.OpticalTables();
  const OpticalTable& table = tables.Tables()[tableIndex];
  const bool preIntegrated = UsesPreIntegration(frame.settings);
  const std::vector<glm::vec4>& entries =
    preIntegrated ? volume.PreIntegrated().Kept().entries : table.entries;
  const int last = preIntegrated ? volume.PreIntegrated().Kept().size - 1 : int(entries.size()) - 1;
  const double extent = table.lastValue - table.firstValue;
  const double indexPerValue = extent > 0.0 ? last / extent : 0.0;
  const std::array<double, 2> visible = frame.settings.mask == Mask::Labels
    ? tables.VisibleValuesOfAny()
    : tables.VisibleValues(tableIndex);
  return { entries.data(), last, float(indexPerValue), float(-table.firstValue * indexPerValue),
    table.entries.front(), table.entries.back(), glm::vec2(visible[0], visible[1]) };
}

PacketGradientOpacity GradientOpacityOf(const Frame& frame, const VolumeResources& volume, int part)
{
  PacketGradientOpacity opacity = {};
  if (frame.settings.gradientOpacity)
  {
    const int channel = OpacityComponentOf(frame.settings, part);
    opacity.factors = volume.GradientOpacity().Entries().data();
    opacity.channel = part;
    opacity.lastIndex = VolumeResources::EntriesPerGradientCurve - 1;
    opacity.indicesPerGradient = frame.geometry.gradientFactors *
      (opacity.lastIndex / LargestGradient(volume.Blocks().TexelsOfChannels()[channel]));
    opacity.unitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance(part));
  }
  return opacity;
}

std::vector<PacketRow> PacketRowsOf(const OpticalTableTexture& tables)
{
  std::vector<PacketRow> rows;
  for (const OpticalTable& table : tables.Tables())
  {
    const int last = int(table.entries.size()) - 1;
    const double extent = table.lastValue - table.firstValue;
    const double indexPerValue = extent > 0.0 ? last / extent : 0.0;
    rows.push_back({ table.entries.data(), last, float(indexPerValue),
      float(-table.firstValue * indexPerValue) });
  }
  return rows;
}

PacketScene PacketSceneOf(
  const Frame& frame, const VolumeResources& volume, const PacketSurroundings& around)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  PacketScene scene = {};
  scene.camera = CameraOf(frame, ComputePixelRays(clipFromGrid, around.drawnBox), around.drawnBox);
  vtkDataArray* const voxels = volume.PacketVoxels();
  scene.volume = { voxels->GetVoidPointer(0), *PacketVoxelTypeOf(voxels), frame.settings.cubic,
    frame.geometry.dimensions };
  scene.look = LookOf(frame, volume, 0);
  scene.twoValues = TwoValuesOf(frame, volume);
  scene.light = LightOf(frame, around.lights, volume.Blocks().Texels().mapping.scale);
  scene.gradientOpacity = GradientOpacityOf(frame, volume, 0);
  scene.mask = MaskOf(frame, volume, around.maskRows);
  scene.gaps = GapsOf(frame, volume);
  scene.extreme = ExtremeOf(frame, volume);
  scene.isosurfaces = { around.isosurfaces.data(), int(around.isosurfaces.size() / 2) };
  scene.projection = ProjectionOf(frame, volume);
  scene.steps = StepsOf(frame, volume);
  scene.cuts.planesGrid = around.planesGrid.data();
  scene.cuts.planeCount = int(around.planesGrid.size());
  if (frame.settings.cropping)
  {
    const CroppingRegions& regions = *frame.cuts.regions;
    scene.cuts.crops = true;
    std::copy(regions.planesGrid.begin(), regions.planesGrid.end(), scene.cuts.regions.planesGrid);
    scene.cuts.regions.drawn = regions.drawn;
  }
  scene.cuts.clipDepthRow = glm::row(clipFromGrid, 2);
  scene.cuts.clipWeightRow = glm::row(clipFromGrid, 3);
  if (around.depth)
  {
    scene.cuts.depth = around.depth;
    scene.cuts.depthPixels = around.depthPixels;
    scene.cuts.depthPixelsPerPixel =
      glm::dvec2(scene.cuts.depthPixels) / glm::dvec2(frame.viewport.width, frame.viewport.height);
  }
  scene.steps.noise = around.noise;
  scene.steps.noiseMask = BlueNoiseTexture::Pixels - 1;
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
    this->scene.rule != PacketRule::Projection && this->scene.gaps.gapOptical.a == 0.0f;
  if (this->scene.steps.bricks && isOfBricks)
  {
    const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
    this->scene.depths = volume.Field().VisibleDepthsIn(clipFromGrid, this->scene.camera, pixels);
  }
}

}
