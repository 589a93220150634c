#include "Unit/PacketPictures.h"

#include "Core/Look/HeadLightShading.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace varimarch
{

namespace
{

constexpr double Largest = 100.0;
constexpr double UnitDistanceMm = PacketPictures::UnitDistanceMm;

constexpr Box BoxOfVoxels()
{
  return { glm::dvec3(0.0), glm::dvec3(PacketPictures::Dimensions - 1) };
}

// Three crossing waves in front, and 0 behind x = 13.
std::vector<std::int16_t> SmoothVoxels()
{
  std::vector<std::int16_t> voxels;
  const glm::ivec3 count = PacketPictures::Dimensions;
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const double x = i % count.x;
    const double y = i / count.x % count.y;
    const double z = i / count.x / count.y;
    const double height = x < 13.0 ? 0.5 * Largest : 0.0;
    const double wave = std::sin(0.7 * x + 0.2 * z) * std::cos(0.6 * y) * std::sin(0.5 * z + 0.4);
    voxels.push_back(std::int16_t(std::lround(height * (1.0 + wave))));
  }
  return voxels;
}

TransferFunction Colorful()
{
  return { { { 20.0, { 0.9, 0.2, 0.1 } }, { 60.0, { 0.2, 0.8, 0.3 } },
             { 90.0, { 0.9, 0.9, 1.0 } } },
    { { 40.0, 0.0 }, { 70.0, 0.3 }, { 100.0, 0.6 } }, UnitDistanceMm };
}

ReferenceView ViewOf(const glm::dmat3& worldFromGrid, glm::ivec2 pixels)
{
  const glm::dvec3 middle = worldFromGrid * (0.5 * glm::dvec3(PacketPictures::Dimensions - 1));
  const glm::dmat4 clipFromWorld = glm::perspective(0.6, double(pixels.x) / pixels.y, 5.0, 100.0) *
    glm::lookAt(middle + glm::dvec3(18.0, 13.0, 24.0), middle, glm::dvec3(0.0, 1.0, 0.0));
  return { ComputePixelRays(clipFromWorld * glm::dmat4(worldFromGrid), BoxOfVoxels()),
    worldFromGrid, pixels.x, pixels.y };
}

RayParameters RaysOf(const ReferenceView& view)
{
  RayParameters rays = {};
  rays.stepMm = 0.02f;
  rays.mostSegments = 100000;
  for (int i = 0; i < 3; ++i)
  {
    rays.rayStartGrid[i] = view.rays.startGrid[i];
    rays.rayDirectionGrid[i] = view.rays.directionGrid[i];
  }
  rays.nearPlaneGrid = view.rays.nearPlaneGrid;
  rays.farPlaneGrid = view.rays.farPlaneGrid;
  rays.boxLowerGrid = BoxOfVoxels().lower;
  rays.boxUpperGrid = BoxOfVoxels().upper;
  rays.viewportPixelsInverse = 1.0 / glm::dvec2(view.width, view.height);
  return rays;
}

VolumeParameters ParametersOf(const glm::dmat3& worldFromGrid)
{
  constexpr double Any = std::numeric_limits<float>::max();
  VolumeParameters parameters = {};
  parameters.worldFromGrid = worldFromGrid;
  parameters.worldFromGradient = glm::transpose(glm::inverse(worldFromGrid));
  parameters.cellsPerBrick = 4.0f;
  parameters.sense = 1.0f;
  parameters.largestScalars = glm::dvec4(Largest);
  parameters.grayPerScalars = glm::dvec4(1.0 / Largest);
  parameters.averagedLower = glm::dvec4(-Any);
  parameters.averagedUpper = glm::dvec4(Any);
  parameters.opacityUnitDistancesMm = glm::dvec4(UnitDistanceMm);
  parameters.partWeights = glm::dvec4(1.0);
  parameters.ownLowerGrid = BoxOfVoxels().lower;
  parameters.ownUpperGrid = BoxOfVoxels().upper;
  parameters.ownGridFromRays = glm::dmat4(1.0);
  return parameters;
}

}

// Neither side of the image is a multiple of a packet's.
PacketPictures::PacketPictures()
  : PacketPictures({ SmoothVoxels(), Colorful(), { 37, 30 } })
{
}

PacketPictures::PacketPictures(PacketSubject subject)
  : scene()
  , truth{ [this](glm::ivec3 cell) { return CornersOfCell(this->Grid(), cell); }, BoxOfVoxels(),
    subject.look }
  , voxels(std::move(subject.voxels))
  , worldFromGrid(1.0, 0.0, 0.0, 0.0, 1.3, 0.0, 0.0, 0.0, 0.8)
  , table(BuildOpticalTable(subject.look, 0.0, Largest))
  , view(ViewOf(worldFromGrid, subject.pixels))
{
  this->scene.rays = RaysOf(this->view);
  this->scene.parameters = ParametersOf(this->worldFromGrid);
  this->scene.volume = { this->voxels.data(), VoxelType::Int16, false, Dimensions };
  this->UseTable(this->table.entries, int(this->table.entries.size()) - 1);
  this->scene.steps.mostOpticalDepth = 100.0f;
  this->scene.steps.brickCount = glm::ivec3(1);
  this->scene.extreme.brickCount = this->scene.extreme.blockCount = glm::ivec3(1);
  this->scene.extreme.bricksPerBlock = 4.0f;
  this->scene.isMean = true;
  this->scene.rule = PacketRule::Midpoint;
  this->truth.grayRange = { 0.0, Largest };
}

void PacketPictures::UseTable(const std::vector<glm::vec4>& entries, int lastIndex)
{
  const double indexPerValue = lastIndex / (this->table.lastValue - this->table.firstValue);
  const std::array<double, 2> visible = VisibleValues(this->table);
  this->scene.look = { entries.data(), lastIndex, float(indexPerValue),
    float(-this->table.firstValue * indexPerValue), this->table.entries.front(),
    this->table.entries.back(), glm::vec2(visible[0], visible[1]), nullptr };
}

void PacketPictures::PreIntegrate()
{
  this->preIntegrated = BuildPreIntegratedTable(this->table);
  const std::vector<glm::vec4>& entries = this->preIntegrated->entries;
  this->UseTable(entries, this->preIntegrated->size - 1);
  this->scene.look.emissionBelow = entries.front();
  this->scene.look.emissionAbove = entries.back();
  this->scene.rule = PacketRule::PreIntegrated;
}

void PacketPictures::LightFromTheEye()
{
  VolumeParameters& parameters = this->scene.parameters;
  this->scene.light.shading = PacketShading::HeadLight;
  parameters.reflectances[0] = glm::dvec4(0.2, 0.7, 0.3, 8.0);
  parameters.diffuseLight = parameters.specularLight = glm::dvec3(1.0);
  this->truth.shade = HeadLightShading(
    { glm::dvec3(0.2), glm::dvec3(0.7), glm::dvec3(0.3), 8.0 },
    [this](glm::ivec3 cell) { return GradientsOfCell(this->Grid(), cell); }, this->worldFromGrid);
}

std::vector<float> PacketPictures::March(InstructionSet set) const
{
  std::vector<float> rgba(std::size_t(4 * this->view.width * this->view.height));
  MarchPackets(this->scene, this->Pixels(), rgba.data(), set);
  return rgba;
}

std::vector<float> PacketPictures::Truth() const
{
  return DrawReference(ReferenceIntegrator(this->truth, 1e-5), this->view)->rgba;
}

}
