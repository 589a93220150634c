#include "Resources/VolumeDivision.h"

#include "Core/Geometry/PixelRays.h"
#include "Core/Geometry/ProjectedBox.h"
#include "Resources/RayAccumulation.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();

// The number of blocks that fill the memory: enough that invisible blocks need not be resident, few
// enough that shared voxels and draw calls cost little.
constexpr std::size_t BlocksInMemory = 16;

// The limits of a volume that is not on the device.
BlockLimits WithoutLimits()
{
  return { std::numeric_limits<int>::max(), 1, NoLimit };
}

void CheckIsDrawnInBlocks(const RenderSettings& settings)
{
  if (settings.uneven)
  {
    throw std::runtime_error("Rectilinear grids cannot be drawn in blocks: the maximum graphics "
                             "memory, or the device's 3D textures, are too small for this one");
  }
  if (settings.countFetches)
  {
    throw std::runtime_error("Fetch counts cannot be drawn for a volume in blocks: the maximum "
                             "graphics memory, or the device's 3D textures, are too small for it");
  }
  if (settings.components != Components::One && settings.blend == Blend::AverageIntensity)
  {
    throw std::runtime_error(
      "The average intensity of several components cannot be drawn for a volume "
      "in blocks: the maximum graphics memory, or the device's 3D textures, "
      "are too small for it");
  }
}

}

std::size_t VolumeDivision::BytesForBlocks(
  const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const std::size_t accumulated =
    std::max(RayAccumulation::BytesFor(march.plan.viewport), elsewhere.accumulationBytes);
  const bool isWhole = this->blocks.Partition().Count() == 1;
  const std::size_t others = elsewhere.fixedBytes + (isWhole ? 0 : accumulated);
  return march.frame.device.mostMemoryBytes == 0
    ? NoLimit
    : march.frame.device.mostMemoryBytes - std::min(march.frame.device.mostMemoryBytes, others);
}

bool VolumeDivision::FitsMemory(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const glm::ivec3 voxels = march.frame.geometry.dimensions;
  const std::size_t most = march.frame.device.mostMemoryBytes;
  const std::size_t wholeBytes = this->blocks.BytesPerVoxel() * voxels.x * voxels.y * voxels.z;
  return most == 0 || elsewhere.fixedBytes + wholeBytes <= most;
}

bool VolumeDivision::MustBeDivided(const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  return !this->FitsMemory(march, elsewhere) ||
    BlockPartition(march.frame.geometry.dimensions, this->LimitsOf(march, elsewhere)).Count() > 1;
}

BlockLimits VolumeDivision::LimitsOf(
  const VolumeMarch& march, const MemoryElsewhere& elsewhere) const
{
  const glm::ivec3 voxels = march.frame.geometry.dimensions;
  BlockLimits limits{ vtkTextureObject::GetMaximumTextureSize3D(march.frame.view.window),
    this->blocks.BytesPerVoxel(), 0 };
  limits.largestBytes = limits.bytesPerVoxel *
    VolumeTexture::MostTexels(glm::min(voxels, limits.largestSide),
      this->blocks.TexelsOfComponents().size(), this->blocks.Format());
  if (this->FitsMemory(march, elsewhere))
  {
    return limits;
  }
  const std::size_t most = march.frame.device.mostMemoryBytes;
  const std::size_t others = elsewhere.fixedBytes +
    std::max(RayAccumulation::BytesFor(march.plan.viewport), elsewhere.accumulationBytes);
  const std::size_t smallest = BlockPartition::SmallestBytes(limits.bytesPerVoxel);
  if (others + smallest > most)
  {
    throw std::runtime_error("Cannot draw in a maximum graphics memory of " + std::to_string(most) +
      " bytes: this image of the volume needs at least " + std::to_string(others + smallest));
  }
  // Sizes are powers of two, so that a resized window rarely changes the division.
  std::size_t largest = most / BlocksInMemory;
  while (largest > most - others)
  {
    largest /= 2;
  }
  limits.largestBytes = std::min(limits.largestBytes, std::max(largest, smallest));
  return limits;
}

bool VolumeDivision::Update(
  const VolumeMarch& march, const FieldResources& fields, const MemoryElsewhere& elsewhere)
{
  vtkOpenGLRenderWindow* const window = march.frame.view.window;
  const bool isForDevice = march.plan.marcher == Marcher::Device;
  this->isTooLarge =
    isForDevice && march.settings.overlaps && this->MustBeDivided(march, elsewhere);
  const bool isInMemory = !isForDevice || this->isTooLarge;
  if (this->blocks.Divide(window, isInMemory ? WithoutLimits() : this->LimitsOf(march, elsewhere)))
  {
    this->visibleOfField = -1;
  }
  this->UpdateVisibleBoxes(march, fields);
  if (isInMemory)
  {
    this->blocks.BeginPicture(window, {}, 0); // releases all blocks
    return false;
  }
  if (this->blocks.Partition().Count() == 1)
  {
    this->blocks.BeginPicture(window, { 0 }, this->BytesForBlocks(march, elsewhere));
    const bool hasGaps = this->blocks.Take(window, 0).HasGaps();
    if (march.settings.uneven && hasGaps)
    {
      throw std::runtime_error("Rectilinear grids cannot be drawn with values that are not finite");
    }
    return hasGaps;
  }
  CheckIsDrawnInBlocks(march.settings);
  return this->blocks.MayHaveGaps();
}

// Rays begin at the box around the visible part, and rays that miss it are not marched.
void VolumeDivision::UpdateVisibleBoxes(const VolumeMarch& march, const FieldResources& fields)
{
  const bool knowsWhatIsVisible = march.settings.acceleration == Acceleration::OpticalField &&
    !IsProjection(march.settings.blend);
  const int fieldBuild = knowsWhatIsVisible ? fields.Builds() : 0;
  const Box& left = march.frame.cuts.boxGrid;
  if (this->visibleOfField == fieldBuild && this->visibleOfBox.lower == left.lower &&
    this->visibleOfBox.upper == left.upper)
  {
    return;
  }
  const auto visible = [&](const Box& box)
  {
    const Box part{ glm::max(box.lower, left.lower), glm::min(box.upper, left.upper) };
    const bool isEmpty = glm::any(glm::greaterThanEqual(part.lower, part.upper));
    return knowsWhatIsVisible && !isEmpty ? fields.OfBricks().VisibleBoxGrid(part) : part;
  };
  const BlockPartition& partition = this->blocks.Partition();
  this->visibleBox = visible(march.frame.geometry.boxGrid);
  this->visibleBoxes.clear();
  for (int block = 0; block < partition.Count(); ++block)
  {
    this->visibleBoxes.push_back(visible(partition.BoxOf(block, march.frame.geometry.boxGrid)));
  }
  this->visibleOfField = fieldBuild;
  this->visibleOfBox = left;
}

std::vector<int> VolumeDivision::InView(const VolumeMarch& march) const
{
  const glm::dmat4 clipFromGrid =
    ClipFromWorld(march.frame.view.renderer) * march.frame.geometry.worldFromGrid;
  const PixelRays rays = ComputePixelRays(clipFromGrid, this->visibleBox);
  std::vector<int> inView;
  for (int block : this->blocks.Partition().FrontToBack(rays.eyeGrid))
  {
    const Box& box = this->visibleBoxes[block];
    if (glm::all(glm::lessThan(box.lower, box.upper)) && IsInView(box, clipFromGrid))
    {
      inView.push_back(block);
    }
  }
  return inView;
}

void VolumeDivision::BeginPicture(
  const VolumeMarch& march, const std::vector<int>& inView, const MemoryElsewhere& elsewhere)
{
  this->blocks.BeginPicture(
    march.frame.view.window, inView, this->BytesForBlocks(march, elsewhere));
}

void VolumeDivision::Release(vtkWindow* window)
{
  this->blocks.Release(window);
  this->visibleOfField = -1;
}

}
