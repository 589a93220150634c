// How the volume is drawn, in one piece or block by block: each of these into the accumulation of
// the rays, front to back, and the accumulation then into the picture.

#include "March/RayMarcher.h"

#include "Core/Geometry/ProjectedBox.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace varimarch
{

namespace
{

// A plane that no ray runs in.
constexpr double Nowhere = 1e30;

}

Box WithItsEdges(const Box& box)
{
  const glm::dvec3 more = glm::max(0.125 * (box.upper - box.lower), glm::dvec3(1.0));
  return { box.lower - more, box.upper + more };
}

bool RayMarcher::IsNothingDrawn() const
{
  return glm::any(glm::greaterThanEqual(this->drawnBox.lower, this->drawnBox.upper));
}

void RayMarcher::DrawVolume(const Frame& frame)
{
  if (this->IsNothingDrawn())
  {
    return;
  }
  if (frame.marcher == Marcher::Processor)
  {
    this->DrawPackets(frame);
    return;
  }
  if (this->volume.Blocks().Partition().Count() == 1)
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
  const std::vector<int> inView = this->volume.BlocksInView(frame);
  this->volume.BeginPicture(frame, inView, this->BytesElsewhere());
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
  DrawnBlock drawn = this->BoxOfVisible();
  drawn.block = &this->volume.Blocks().Take(frame.window, 0);
  drawn.voxels = { glm::ivec3(0), frame.geometry.dimensions };
  return drawn;
}

void RayMarcher::DrawBlock(Frame frame, int block)
{
  const BlockPartition& partition = this->volume.Blocks().Partition();
  const Box& volumeBox = frame.geometry.boxGrid;
  const Box& visible = this->volume.VisibleBoxOf(block);
  const glm::dvec3 upper = partition.BoxOf(block, volumeBox).upper;
  // Which of two neighbours has a ray along their common face is for the ray to say, not for the
  // rasteriser: the cover reaches farther.
  const Box cover =
    frame.addsUp ? WithItsEdges(visible) : Box{ visible.lower - 0.5, visible.upper + 0.5 };
  // What cuts leave may end at a face of the block: then none begins behind it.
  const glm::bvec3 isShared = glm::lessThan(upper, frame.cuts.boxGrid.upper);
  const DrawnBlock drawn{ &this->volume.Blocks().Take(frame.window, block),
    partition.VoxelsOf(block), visible, cover, glm::mix(glm::dvec3(Nowhere), upper, isShared) };
  frame.settings.gaps = drawn.block->HasGaps();
  this->UpdateProgram(frame);
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  this->accumulation.Keep(PixelsOf(cover, clipFromGrid, frame.viewport));
  this->DrawBox(frame, drawn);
}

}
