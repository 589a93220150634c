#include "Resources/LightResources.h"

#include "Core/Look/OpticalTable.h"
#include "Core/Recipe/ShaderRecipe.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace varimarch
{

namespace
{

// The differences between the nodes of a cell, in parts of the error of light: light between nodes
// differs from their interpolation by a small part of that.
constexpr double AgreementOfError = 32.0;

// The largest difference between the nodes of a cell at which the light from all around is
// interpolated. It is the same for all tolerances: such cells err by up to a hundredth, for which
// ErrorBudget keeps a share.
constexpr float SkyAgreement = 0.35f;

// The least error of light with which these cells are used.
constexpr double SkyCellError = 1.0 / 1024.0;

// The optical depth beyond which no light is left if there is no tolerance.
constexpr float MostDepthOfTraced = 12.0f;

// The optical depth of an opaque voxel in light. A twentieth of it is opaque in any image, and
// floats tell places in it apart.
constexpr double DepthOfOpaqueVoxel = 256.0;

// The error of each of the rays to all sides, in parts of that of their mean.
constexpr double ErrorOfOneRay = 4.0;

// The side of the voxels that rays to all sides go through. Shaders march rays through all volumes
// by the same steps.
double OccluderVoxelMm(const VolumeMarch& march)
{
  return march.plan.marcher == Marcher::Device ? march.frame.material.occluderVoxelMm
                                               : march.frame.geometry.SmallestSpacingMm();
}

// The longest segments of rays from nodes, in voxels. The error of a segment is of second order.
double NodeStepVoxels(double error)
{
  constexpr double ErrorOfAVoxel = 1.0 / 512.0;
  constexpr double LongestVoxels = 0.5;
  return std::min(LongestVoxels, std::sqrt(error / ErrorOfAVoxel));
}

// True if matter takes so little light over a voxel that a shadow is as wide as a cell.
bool IsSmooth(const MaterialResources& materials, double voxelMm)
{
  constexpr double MostDepthOfVoxel = 4.0;
  return materials.MostExtinction() * voxelMm <= MostDepthOfVoxel;
}

// The number of lattices whose light is multiplied, and whose errors add up.
double LatticesOfALight(const VolumeMarch& march)
{
  return double(march.plan.budget.volumeCount) * PartCount(march.settings);
}

// All inputs of a light's way through the volume, without those of the light itself.
Fingerprint InputsOf(const VolumeMarch& march)
{
  return Fingerprint(march.frame.extinction, march.frame.geometry.worldFromGrid,
    march.plan.budget.LightError(), LatticesOfALight(march));
}

}

void LightResources::Update(const VolumeMarch& march, const MaterialResources& materials)
{
  this->shadows.assign(std::size_t(PartCount(march.settings)), {});
  this->sky = {};
  std::vector<Kept> now;
  if (march.plan.marcher == Marcher::Processor)
  {
    this->UpdateShadows(march, materials, now);
  }
  this->UpdateSky(march, now);
  // While a user interacts, images have no occlusion, but its nodes stay for the still image.
  this->sky = IsInWayOfSky(march.settings) ? this->sky : PacketSky();
  this->UpdateDirections(march);
  this->UpdateSums(march, materials);
  this->kept = std::move(now);
}

void LightResources::UpdateShadows(
  const VolumeMarch& march, const MaterialResources& materials, std::vector<Kept>& now)
{
  const double error = march.plan.budget.LightError();
  const double errorOfLattice = error / LatticesOfALight(march);
  const double voxelMm = march.frame.geometry.SmallestSpacingMm();
  const bool isWhole = std::isinf(march.frame.material.shadowReachMm);
  // Light through blocks of other levels is other light.
  const bool hasLattices = IsInWayOfLights(march.settings) && isWhole && error > 0.0 &&
    IsSmooth(materials, voxelMm) && !march.frame.blockLevels;
  for (PacketShadows& ofPart : this->shadows)
  {
    ofPart.tolerance = float(error);
    if (IsInWayOfLights(march.settings))
    {
      ofPart.mostExtinction = float(DepthOfOpaqueVoxel / voxelMm);
    }
    if (hasLattices)
    {
      ofPart.shape = LightLattice::ShapeOfLight(march.frame.geometry.dimensions);
      ofPart.nodeStepMm = float(NodeStepVoxels(errorOfLattice) * voxelMm);
      ofPart.agreement = float(AgreementOfError * errorOfLattice);
    }
  }
  if (hasLattices)
  {
    this->KeepLattices(march, now);
  }
}

void LightResources::KeepLattices(const VolumeMarch& march, std::vector<Kept>& now)
{
  const LightTexels& lights = march.frame.lights.lamps;
  const int count = std::min(lights.Count(), MostShadowedLights);
  const Fingerprint volumeInputs = InputsOf(march);
  for (int light = 0; light < count; ++light)
  {
    for (std::size_t part = 0; part < this->shadows.size(); ++part)
    {
      const glm::vec4& place = lights.texels[std::size_t(light) * LightTexels::PerLight];
      Fingerprint inputs(volumeInputs, place, light < lights.distantCount, part);
      PacketShadows& ofPart = this->shadows[part];
      // The mean over the cone of a soft light is of products, and so no product of means.
      if (place.w == 0.0f || LatticesOfALight(march) == 1.0)
      {
        ofPart.nodes[light] = this->KeepNodes(std::move(inputs), ofPart.shape, now);
      }
    }
  }
}

void LightResources::UpdateSky(const VolumeMarch& march, std::vector<Kept>& now)
{
  if (!IsInWayOfSky(march.frame.settings))
  {
    return;
  }
  const double strength = march.frame.material.occlusion;
  const glm::dmat3 gridFromWorld = glm::inverse(march.frame.geometry.WorldFromGridDirection());
  this->sky.strength = march.frame.settings.occlusion ? float(strength) : 0.0f;
  this->sky.reachMm = float(march.frame.material.occlusionReachMm);
  for (int i = 0; i < SphereDirections; ++i)
  {
    const WeightedDirection& one = SphereQuadrature()[std::size_t(i)];
    this->sky.directions[i] = glm::dvec4(gridFromWorld * one.direction, one.weight);
  }
  // The light that is kept changes by up to 1 / strength times what rays miss.
  const double error = strength * march.plan.budget.LightError() / LatticesOfALight(march);
  if (!(error > 0.0))
  {
    this->sky.mostDepth = MostDepthOfTraced;
    return;
  }
  this->sky.nodeStepMm = float(NodeStepVoxels(ErrorOfOneRay * error) * OccluderVoxelMm(march));
  this->sky.mostDepth = float(-std::log(error));
  // Light through blocks of other levels is other light.
  if (march.plan.marcher == Marcher::Device || !march.frame.settings.occlusion ||
    march.plan.budget.LightError() < SkyCellError || march.frame.blockLevels)
  {
    return;
  }
  this->sky.shape = LightLattice::ShapeOfSky(march.frame.geometry.dimensions);
  this->sky.agreement = SkyAgreement;
  Fingerprint inputs(
    InputsOf(march), strength, march.frame.material.occlusionReachMm, march.frame.occluders);
  this->sky.nodes = this->KeepNodes(std::move(inputs), this->sky.shape, now);
}

PacketShadows LightResources::Shadows(const VolumeMarch& march, int part) const
{
  PacketShadows ofPart = this->shadows[std::size_t(part)];
  ofPart.agreement *= float(march.plan.light.latticePart);
  if (march.plan.light.IsTraced())
  {
    std::fill(std::begin(ofPart.nodes), std::end(ofPart.nodes), nullptr);
  }
  return ofPart;
}

PacketSky LightResources::Sky(const VolumeMarch& march) const
{
  const double voxelMm = OccluderVoxelMm(march);
  PacketSky ofMarch = this->sky;
  ofMarch.stepMm =
    float(march.plan.budget.HasTolerance() ? march.plan.OcclusionStepMm(voxelMm)
                                           : std::min(voxelMm, march.plan.sampleDistanceMm));
  ofMarch.agreement *= float(march.plan.light.latticePart);
  ofMarch.nodes = march.plan.light.IsTraced() ? nullptr : ofMarch.nodes;
  return ofMarch;
}

void LightResources::UpdateDirections(const VolumeMarch& march)
{
  std::vector<glm::vec4> texels;
  if (march.plan.marcher == Marcher::Device && march.settings.occlusion)
  {
    texels.assign(this->sky.directions, this->sky.directions + SphereDirections);
  }
  this->directions.Set(march.frame.view.window, std::move(texels));
  this->directions.Update(march.frame.view.window, march.plan.marcher);
}

void LightResources::UpdateSums(const VolumeMarch& march, const MaterialResources& materials)
{
  const bool areRead = march.plan.marcher == Marcher::Processor &&
    (IsInWayOfLights(march.settings) || IsInWayOfSky(march.settings));
  if (!areRead)
  {
    this->sums.clear();
    this->sumInputs = {};
    return;
  }
  const double mostExtinction = DepthOfOpaqueVoxel / march.frame.geometry.SmallestSpacingMm();
  Fingerprint inputs(materials.TableBuilds(), mostExtinction);
  if (this->sumInputs == inputs)
  {
    return;
  }
  this->sumInputs = std::move(inputs);
  this->sums.clear();
  for (const OpticalTable& table : materials.OpticalTables().Tables())
  {
    this->sums.push_back(ExtinctionSums(table, mostExtinction));
  }
}

void LightResources::Release(vtkWindow* window)
{
  this->kept.clear();
  this->directions.Release(window);
}

// The nodes of a lattice that is kept, or of an empty one.
std::uint8_t* LightResources::KeepNodes(
  Fingerprint inputs, const LatticeShape& shape, std::vector<Kept>& now)
{
  const auto found = std::find_if(
    this->kept.begin(), this->kept.end(), [&](const Kept& own) { return own.inputs == inputs; });
  if (found != this->kept.end())
  {
    now.push_back(std::move(*found));
  }
  else
  {
    now.push_back({ std::move(inputs), LightLattice(shape) });
    ++this->builds;
  }
  return now.back().lattice.Nodes();
}

std::size_t LightResources::Bytes() const
{
  std::size_t bytes = 0;
  for (const Kept& one : this->kept)
  {
    bytes += one.lattice.Bytes();
  }
  return bytes;
}

}
