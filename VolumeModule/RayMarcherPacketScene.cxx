// A frame in plain numbers, as packets of rays are marched by it.

#include "RayMarcher.h"

#include "Core/Packets/PacketMarch.h"
#include "Core/ShaderRecipe.h"

#include "vtkDataArray.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>
#include <limits>

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

}

std::optional<VoxelType> PacketVoxelTypeOf(const VoxelChannels& channels)
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

VoxelChannels RayMarcher::ChannelsReadBy(const Frame& frame) const
{
  return frame.settings.cubic ? this->spline.Channels() : frame.channels;
}

PacketTwoValues RayMarcher::TwoValuesOfPackets(const Frame& frame) const
{
  PacketTwoValues look = {};
  if (frame.settings.functionOf == FunctionOf::ValueAndGradient)
  {
    const ScalarTexels& texels = this->blocks.Texels();
    const double range = texels.largestScalar - texels.smallestScalar;
    const double placePerValue = range > 0.0 ? 1.0 / range : 0.0;
    look.entries = this->twoValues.Entries().data();
    look.size = this->twoValuesSize;
    look.placeScale = float(placePerValue);
    look.placeOffset = float(-texels.smallestScalar * placePerValue);
    look.placesPerGradient = frame.geometry.gradientFactors / LargestGradient(texels);
    look.unitDistanceMm = float(frame.property->GetScalarOpacityUnitDistance());
  }
  return look;
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
    opacity.factors = this->gradientOpacity.Entries().data();
    opacity.lastIndex = int(this->gradientOpacity.Entries().size()) - 1;
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

PacketProjection RayMarcher::ProjectionOfPackets(const Frame& frame) const
{
  const ScalarTexels& texels = this->blocks.Texels();
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

PacketScene RayMarcher::SceneOfPackets(const Frame& frame, const PacketArrays& arrays) const
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  PacketScene scene = {};
  scene.camera = CameraOf(frame, ComputePixelRays(clipFromGrid, this->drawnBox), this->drawnBox);
  const VoxelChannels channels = this->ChannelsReadBy(frame);
  scene.volume = { channels.front().array->GetVoidPointer(0), *PacketVoxelTypeOf(channels),
    frame.settings.cubic, frame.geometry.dimensions };
  scene.look = this->LookOfPackets(frame);
  scene.twoValues = this->TwoValuesOfPackets(frame);
  scene.light = LightOf(frame, arrays.lights, this->blocks.Texels().mapping.scale);
  scene.gradientOpacity = this->GradientOpacityOfPackets(frame);
  scene.extreme = this->ExtremeOfPackets(frame);
  scene.isosurfaces = { arrays.isosurfaces.data(), int(arrays.isosurfaces.size() / 2) };
  scene.projection = this->ProjectionOfPackets(frame);
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

}
