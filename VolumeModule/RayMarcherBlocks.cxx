// How a volume becomes blocks, and how these make one picture: each is drawn into the accumulation
// of the rays, front to back, and the accumulation then into the picture.

#include "RayMarcher.h"

#include "BoxInView.h"
#include "Core/PreIntegratedTable.h"
#include "Core/ShaderRecipe.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
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

// A plane that no ray runs in.
constexpr double Nowhere = 1e30;

}

Box WithItsEdges(const Box& box)
{
  const glm::dvec3 more = glm::max(0.125 * (box.upper - box.lower), glm::dvec3(1.0));
  return { box.lower - more, box.upper + more };
}

// Of the graphics memory, all that is not blocks nor their accumulation.
std::size_t RayMarcher::FixedBytes(const Frame& frame) const
{
  const bool isTriedOut = frame.errorTolerance > 0.0 && frame.settings.blend == Blend::Composite;
  const bool mayPreIntegrate =
    UsesPreIntegration(frame.settings) || (isTriedOut && frame.triesPreIntegration);
  const Viewport probed = ProbeFramebuffer::PixelsFor(frame.viewport);
  const std::size_t probeBytes = 4 * sizeof(float) * probed.width * probed.height;
  return this->clippingPlanes.Bytes() + this->isosurfaces.Bytes() + this->spacing.Bytes() +
    this->field.Bytes() + this->opticalTable.Bytes() + this->depth.Bytes() + this->lights.Bytes() +
    this->gradientOpacity.Bytes() + this->twoValues.Bytes() + this->mask.Bytes() +
    this->picture.Bytes() + this->BytesOfOthers() +
    (mayPreIntegrate ? PreIntegratedTableBytes(this->opticalTable.Table()) : 0) +
    (frame.errorTolerance > 0.0 ? probeBytes : 0);
}

std::size_t RayMarcher::BytesForBlocks(const Frame& frame) const
{
  const std::size_t accumulated =
    std::max(RayAccumulation::BytesFor(frame.viewport), this->accumulation.Bytes());
  const bool isWhole = this->blocks.Partition().Count() == 1;
  const std::size_t others = this->FixedBytes(frame) + (isWhole ? 0 : accumulated);
  return frame.mostMemoryBytes == 0
    ? NoLimit
    : frame.mostMemoryBytes - std::min(frame.mostMemoryBytes, others);
}

BlockLimits RayMarcher::LimitsOf(const Frame& frame) const
{
  BlockLimits limits{ vtkTextureObject::GetMaximumTextureSize3D(frame.window),
    this->blocks.BytesPerVoxel(), NoLimit };
  const std::size_t most = frame.mostMemoryBytes;
  const glm::ivec3 voxels = frame.geometry.dimensions;
  const std::size_t fixedBytes = this->FixedBytes(frame);
  const std::size_t wholeBytes = limits.bytesPerVoxel * voxels.x * voxels.y * voxels.z;
  if (most == 0 || fixedBytes + wholeBytes <= most)
  {
    return limits;
  }
  const std::size_t others =
    fixedBytes + std::max(RayAccumulation::BytesFor(frame.viewport), this->accumulation.Bytes());
  const std::size_t smallest = BlockPartition::SmallestBytes(limits.bytesPerVoxel);
  if (others + smallest > most)
  {
    throw std::runtime_error("Cannot draw in a maximum graphics memory of " + std::to_string(most) +
      " bytes: this picture of this volume needs at least " + std::to_string(others + smallest));
  }
  // In powers of two, so that another size of the window hardly ever divides the volume anew.
  limits.largestBytes = most / BlocksInMemory;
  while (limits.largestBytes > most - others)
  {
    limits.largestBytes /= 2;
  }
  limits.largestBytes = std::max(limits.largestBytes, smallest);
  return limits;
}

void RayMarcher::UpdateBlocks(Frame& frame)
{
  // To try a rule out, its table must not leave little memory to the volume.
  frame.triesPreIntegration = frame.mostMemoryBytes == 0 ||
    4 * PreIntegratedTableBytes(this->opticalTable.Table()) <= frame.mostMemoryBytes;
  frame.chooseIntegration =
    frame.chooseIntegration && (frame.triesPreIntegration || MarchesMaterial(frame.settings));
  const bool isWhole = frame.marcher == Marcher::Processor;
  if (this->blocks.Divide(frame.window, isWhole ? WithoutLimits() : this->LimitsOf(frame)))
  {
    this->visibleOfField = -1;
  }
  this->UpdateVisibleBoxes(frame);
  if (isWhole)
  {
    this->accumulation.Release(frame.window);
    this->blocks.BeginPicture(frame.window, {}, 0); // which lets go of all
    return;
  }
  if (this->blocks.Partition().Count() == 1)
  {
    this->accumulation.Release(frame.window);
    this->blocks.BeginPicture(frame.window, { 0 }, this->BytesForBlocks(frame));
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
void RayMarcher::UpdateVisibleBoxes(const Frame& frame)
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
std::vector<int> RayMarcher::BlocksInView(const Frame& frame) const
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

void RayMarcher::DrawVolume(const Frame& frame)
{
  if (glm::any(glm::greaterThanEqual(this->drawnBox.lower, this->drawnBox.upper)))
  {
    return;
  }
  if (frame.marcher == Marcher::Processor)
  {
    this->DrawPackets(frame);
    return;
  }
  if (this->blocks.Partition().Count() == 1)
  {
    this->UpdateProgram(frame);
    DrawnBlock drawn = this->WholeVolume(frame);
    drawn.coverGrid = frame.addsUp ? WithItsEdges(drawn.coverGrid) : drawn.coverGrid;
    this->DrawBox(frame, drawn);
    return;
  }
  this->DrawBlocks(frame);
}

void RayMarcher::DrawBlocks(const Frame& frame)
{
  const std::vector<int> inView = this->BlocksInView(frame);
  this->blocks.BeginPicture(frame.window, inView, this->BytesForBlocks(frame));
  Frame blockFrame = frame;
  blockFrame.viewport = { 0, 0, frame.viewport.width, frame.viewport.height };
  blockFrame.settings.pass = RayPass::Block;
  this->accumulation.Draw(frame.window, blockFrame.viewport,
    [&]
    {
      for (int block : inView)
      {
        this->DrawBlock(blockFrame, block);
      }
    });

  Frame picture = frame;
  picture.settings.pass = RayPass::Picture;
  this->UpdateProgram(picture);
  DrawnBlock drawn = this->BoxOfVisible();
  drawn.coverGrid = frame.addsUp ? WithItsEdges(drawn.coverGrid) : drawn.coverGrid;
  this->DrawBox(picture, drawn);
}

DrawnBlock RayMarcher::BoxOfVisible() const
{
  return { nullptr, {}, this->drawnBox, this->drawnBox, glm::dvec3(Nowhere) };
}

DrawnBlock RayMarcher::WholeVolume(const Frame& frame)
{
  return { &this->blocks.Take(frame.window, 0), { glm::ivec3(0), frame.geometry.dimensions },
    this->drawnBox, this->drawnBox, glm::dvec3(Nowhere) };
}

void RayMarcher::DrawBlock(Frame frame, int block)
{
  const BlockPartition& partition = this->blocks.Partition();
  const Box& volumeBox = frame.geometry.boxGrid;
  const Box& visible = this->visibleBoxes[block];
  const glm::dvec3 upper = partition.BoxOf(block, volumeBox).upper;
  // Which of two neighbours has a ray along their common face is for the ray to say, not for the
  // rasteriser: the cover reaches farther.
  const Box cover =
    frame.addsUp ? WithItsEdges(visible) : Box{ visible.lower - 0.5, visible.upper + 0.5 };
  // What cuts leave may end at a face of the block: then none begins behind it.
  const glm::bvec3 isShared = glm::lessThan(upper, frame.cuts.boxGrid.upper);
  const DrawnBlock drawn{ &this->blocks.Take(frame.window, block), partition.VoxelsOf(block),
    visible, cover, glm::mix(glm::dvec3(Nowhere), upper, isShared) };
  frame.settings.gaps = drawn.block->HasGaps();
  this->UpdateProgram(frame);
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  this->accumulation.Keep(PixelsOf(cover, clipFromGrid, frame.viewport));
  this->DrawBox(frame, drawn);
}

}
