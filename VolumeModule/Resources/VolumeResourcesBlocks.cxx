// How a volume becomes blocks, what of them may be seen, and the memory that these may take.

#include "Resources/VolumeResources.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/ToleranceSearch.h"
#include "Resources/FloatFramebuffer.h"
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

// So many blocks fill the memory: enough that what is not seen can stay away, few enough that
// their shared voxels and draw calls hardly count.
constexpr std::size_t BlocksInMemory = 16;

// Of a volume that is not on the device.
BlockLimits WithoutLimits()
{
  return { std::numeric_limits<int>::max(), 1, NoLimit };
}

void CheckIsDrawnInBlocks(const RenderSettings& settings)
{
  if (settings.uneven)
  {
    throw std::runtime_error("Rectilinear grids are not drawn in blocks: the maximum graphics "
                             "memory, or the device's 3D textures, are too small for this one");
  }
  if (settings.countFetches)
  {
    throw std::runtime_error("Fetch counts are not drawn for a volume in blocks: the maximum "
                             "graphics memory, or the device's 3D textures, are too small for it");
  }
  if (settings.components != Components::One && settings.blend == Blend::AverageIntensity)
  {
    throw std::runtime_error(
      "The average intensity of several components is not drawn for a volume "
      "in blocks: the maximum graphics memory, or the device's 3D textures, "
      "are too small for it");
  }
}

}

// Of the graphics memory, all that is not blocks nor their accumulation.
std::size_t VolumeResources::FixedBytes(const Frame& frame, const MemoryElsewhere& elsewhere) const
{
  const bool isTriedOut = frame.errorTolerance > 0.0 && frame.settings.blend == Blend::Composite;
  const bool mayPreIntegrate =
    UsesPreIntegration(frame.settings) || (isTriedOut && frame.triesPreIntegration);
  const std::size_t probeBytes = FloatFramebuffer::BytesFor(ProbePixelsFor(frame.viewport));
  return this->BytesBesideBlocks() + elsewhere.fixedBytes +
    (mayPreIntegrate ? PreIntegratedTableBytes(this->opticalTable.Table()) : 0) +
    (frame.errorTolerance > 0.0 ? probeBytes : 0);
}

std::size_t VolumeResources::BytesForBlocks(
  const Frame& frame, const MemoryElsewhere& elsewhere) const
{
  const std::size_t accumulated =
    std::max(RayAccumulation::BytesFor(frame.viewport), elsewhere.accumulationBytes);
  const bool isWhole = this->blocks.Partition().Count() == 1;
  const std::size_t others = this->FixedBytes(frame, elsewhere) + (isWhole ? 0 : accumulated);
  return frame.mostMemoryBytes == 0
    ? NoLimit
    : frame.mostMemoryBytes - std::min(frame.mostMemoryBytes, others);
}

BlockLimits VolumeResources::LimitsOf(const Frame& frame, const MemoryElsewhere& elsewhere) const
{
  const glm::ivec3 voxels = frame.geometry.dimensions;
  BlockLimits limits{ vtkTextureObject::GetMaximumTextureSize3D(frame.window),
    this->blocks.BytesPerVoxel(), 0 };
  limits.largestBytes = limits.bytesPerVoxel *
    VolumeTexture::MostTexels(
      glm::min(voxels, limits.largestSide), this->blocks.TexelsOfComponents());
  const std::size_t most = frame.mostMemoryBytes;
  const std::size_t fixedBytes = this->FixedBytes(frame, elsewhere);
  const std::size_t wholeBytes = limits.bytesPerVoxel * voxels.x * voxels.y * voxels.z;
  if (most == 0 || fixedBytes + wholeBytes <= most)
  {
    return limits;
  }
  const std::size_t others =
    fixedBytes + std::max(RayAccumulation::BytesFor(frame.viewport), elsewhere.accumulationBytes);
  const std::size_t smallest = BlockPartition::SmallestBytes(limits.bytesPerVoxel);
  if (others + smallest > most)
  {
    throw std::runtime_error("Cannot draw in a maximum graphics memory of " + std::to_string(most) +
      " bytes: this picture of this volume needs at least " + std::to_string(others + smallest));
  }
  // In powers of two, so that another size of the window hardly ever divides the volume anew.
  std::size_t largest = most / BlocksInMemory;
  while (largest > most - others)
  {
    largest /= 2;
  }
  limits.largestBytes = std::min(limits.largestBytes, std::max(largest, smallest));
  return limits;
}

void VolumeResources::UpdateBlocks(Frame& frame, const MemoryElsewhere& elsewhere)
{
  // To try a rule out, its table must not leave little memory to the volume.
  frame.triesPreIntegration = frame.mostMemoryBytes == 0 ||
    4 * PreIntegratedTableBytes(this->opticalTable.Table()) <= frame.mostMemoryBytes;
  frame.chooseIntegration =
    frame.chooseIntegration && (frame.triesPreIntegration || MarchesMaterial(frame.settings));
  const bool isWhole = frame.marcher == Marcher::Processor;
  if (this->blocks.Divide(
        frame.window, isWhole ? WithoutLimits() : this->LimitsOf(frame, elsewhere)))
  {
    this->visibleOfField = -1;
  }
  this->UpdateVisibleBoxes(frame);
  if (isWhole)
  {
    this->blocks.BeginPicture(frame.window, {}, 0); // which lets go of all
    return;
  }
  if (this->blocks.Partition().Count() == 1)
  {
    this->blocks.BeginPicture(frame.window, { 0 }, this->BytesForBlocks(frame, elsewhere));
    frame.settings.gaps = this->blocks.Take(frame.window, 0).HasGaps();
    if (frame.settings.uneven && frame.settings.gaps)
    {
      throw std::runtime_error("Rectilinear grids with values that are not finite are not drawn");
    }
    return;
  }
  CheckIsDrawnInBlocks(frame.settings);
  frame.settings.gaps = this->blocks.MayHaveGaps(); // each block will tell
}

// Rays outside what can be seen are not begun, and others begin where it does.
void VolumeResources::UpdateVisibleBoxes(const Frame& frame)
{
  const bool knowsWhatIsVisible = frame.settings.acceleration == Acceleration::OpticalField &&
    !IsProjection(frame.settings.blend);
  const int fieldBuild = knowsWhatIsVisible ? this->builds.field : 0;
  const Box& left = frame.cuts.boxGrid;
  if (this->visibleOfField == fieldBuild && this->visibleOfBox.lower == left.lower &&
    this->visibleOfBox.upper == left.upper)
  {
    return;
  }
  const auto visible = [&](const Box& box)
  {
    const Box part{ glm::max(box.lower, left.lower), glm::min(box.upper, left.upper) };
    const bool isEmpty = glm::any(glm::greaterThanEqual(part.lower, part.upper));
    return knowsWhatIsVisible && !isEmpty ? this->field.VisibleBoxGrid(part) : part;
  };
  const BlockPartition& partition = this->blocks.Partition();
  this->visibleBox = visible(frame.geometry.boxGrid);
  this->visibleBoxes.clear();
  for (int block = 0; block < partition.Count(); ++block)
  {
    this->visibleBoxes.push_back(visible(partition.BoxOf(block, frame.geometry.boxGrid)));
  }
  this->visibleOfField = fieldBuild;
  this->visibleOfBox = left;
}

// Those in which something visible may be in view, front to back.
std::vector<int> VolumeResources::BlocksInView(const Frame& frame) const
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
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

void VolumeResources::BeginPicture(
  const Frame& frame, const std::vector<int>& inView, const MemoryElsewhere& elsewhere)
{
  this->blocks.BeginPicture(frame.window, inView, this->BytesForBlocks(frame, elsewhere));
}

}
