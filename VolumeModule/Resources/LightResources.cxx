#include "Resources/LightResources.h"

#include "Frame/Lights.h"
#include "Frame/SceneFingerprint.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

// The differences between the nodes of a cell, in parts of the error of light: light between nodes
// differs from their interpolation by a small part of that.
constexpr double AgreementOfError = 32.0;

// The longest segments of rays from nodes, in voxels. The error of a segment is of second order.
double NodeStepVoxels(const ErrorBudget& budget)
{
  constexpr double ErrorOfAVoxel = 1.0 / 512.0;
  return std::min(1.0, std::sqrt(budget.LightError() / ErrorOfAVoxel));
}

// True if matter takes so little light over a voxel that a shadow is as wide as a cell.
bool IsSmooth(const MaterialResources& materials, double voxelMm)
{
  constexpr double MostDepthOfVoxel = 4.0;
  double most = 0.0;
  for (const OpticalTable& table : materials.OpticalTables().Tables())
  {
    for (const glm::vec4& entry : table.entries)
    {
      most = std::max(most, double(entry.w));
    }
  }
  return most * voxelMm <= MostDepthOfVoxel;
}

// All inputs of a light's way through the volume, without those of the light itself.
std::vector<double> InputsOf(const VolumeMarch& march)
{
  std::vector<double> inputs = MaterialFingerprint(march.frame);
  const glm::dmat4& world = march.frame.geometry.worldFromGrid;
  inputs.insert(inputs.end(), glm::value_ptr(world), glm::value_ptr(world) + 16);
  inputs.insert(inputs.end(),
    { double(march.settings.cubic), march.plan.budget.LightError(),
      double(march.settings.acceleration) });
  return inputs;
}

}

void LightResources::Update(const VolumeMarch& march, const MaterialResources& materials)
{
  const double error = march.plan.budget.LightError();
  const double voxelMm = march.frame.geometry.SmallestSpacingMm();
  this->shadows = {};
  this->shadows.tolerance = float(error);
  if (!march.settings.shadows || march.plan.marcher == Marcher::Device || !(error > 0.0) ||
    !IsSmooth(materials, voxelMm))
  {
    this->kept.clear();
    return;
  }
  this->shadows.nodeCount = LightLattice::NodeCount(march.frame.geometry.dimensions);
  this->shadows.nodeStepMm = float(NodeStepVoxels(march.plan.budget) * voxelMm);
  this->shadows.agreement = float(AgreementOfError * error);

  const LightTexels lights = LightTexelsOf(march.frame.view.renderer);
  const int count = std::min(lights.distantCount + lights.nearCount, MostShadowedLights);
  const std::vector<double> volumeInputs = InputsOf(march);
  std::vector<Kept> now;
  for (int light = 0; light < count; ++light)
  {
    std::vector<double> inputs = volumeInputs;
    const glm::vec4& place = lights.texels[std::size_t(light) * LightTexels::PerLight];
    inputs.insert(inputs.end(), { place.x, place.y, place.z, double(light < lights.distantCount) });
    now.push_back(this->TakeKept(inputs, march.frame.geometry.dimensions));
    this->shadows.nodes[light] = now.back().lattice.Nodes();
  }
  this->kept = std::move(now);
}

LightResources::Kept LightResources::TakeKept(
  const std::vector<double>& inputs, const glm::ivec3& voxelCount)
{
  const auto found = std::find_if(
    this->kept.begin(), this->kept.end(), [&](const Kept& own) { return own.inputs == inputs; });
  return found == this->kept.end() ? Kept{ inputs, LightLattice(voxelCount) } : std::move(*found);
}

PacketShadows LightResources::Shadows() const
{
  return this->shadows;
}

}
