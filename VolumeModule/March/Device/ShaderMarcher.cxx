#include "March/Device/ShaderMarcher.h"

#include "Core/Geometry/ProjectedBox.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <vector>

namespace varimarch
{

void BlockMarch::Draw(const Frame& frame, const MarchPlan& plan)
{
  const VolumeMarch march = MarchOf(frame, plan);
  const std::vector<int> inView = this->resources.First().Division().InView(march);
  this->resources.BeginPicture(march, inView, this->ofImages());
  const Viewport rays{ 0, 0, plan.viewport.width, plan.viewport.height };
  const MarchPlan blockPlan = plan.WithPass(RayPass::Block).WithViewport(rays);
  this->accumulation.Draw(frame.view.window, rays,
    [&]
    {
      for (int block : inView)
      {
        this->DrawBlock(frame, blockPlan, block);
      }
    });

  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = CoverOfRays(frame, plan, drawn.coverGrid);
  EarlierDrawings earlier;
  earlier.gathered = this->accumulation.Finished();
  this->boxes.Draw(frame, plan.WithPass(RayPass::Picture), drawn, earlier);
}

void BlockMarch::DrawBlock(const Frame& frame, MarchPlan plan, int block)
{
  VolumeResources& volume = this->resources.First();
  const BlockPartition& partition = volume.Blocks().Partition();
  const Box& visible = volume.Division().VisibleBoxOf(block);
  DrawnBlock drawn = AllThatIsVisible(visible);
  drawn.block = &volume.Blocks().Take(frame.view.window, block);
  drawn.voxels = partition.VoxelsOf(block);
  // The shader, not the rasteriser, decides which of two blocks a ray enters at their common face,
  // so the cover is larger than the block.
  drawn.coverGrid = CoverOfRays(frame, plan, { visible.lower - 0.5, visible.upper + 0.5 });
  // A cut may end the volume at a face of the block; no other block begins there then.
  const glm::dvec3 upper = partition.BoxOf(block, frame.geometry.boxGrid).upper;
  const glm::bvec3 isShared = glm::lessThan(upper, frame.cuts.boxGrid.upper);
  drawn.sharedUpperGrid = glm::mix(drawn.sharedUpperGrid, upper, isShared);

  const glm::dmat4 clipFromGrid = frame.ClipFromGrid();
  this->accumulation.Keep(PixelsOf(drawn.coverGrid, clipFromGrid, plan.viewport));
  EarlierDrawings earlier;
  earlier.gathered = this->accumulation.Drawn();
  plan.volumes.front().hasGaps = drawn.block->HasGaps();
  this->boxes.Draw(frame, plan, drawn, earlier);
}

void ShaderMarcher::Draw(const Frame& frame, const MarchPlan& plan)
{
  if (this->resources.IsNothingDrawn())
  {
    return;
  }
  if (this->resources.IsInBlocks())
  {
    this->blocks.Draw(frame, plan);
    return;
  }
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.block = &this->resources.First().Blocks().Take(frame.view.window, 0);
  drawn.voxels = { glm::ivec3(0), frame.geometry.dimensions };
  drawn.coverGrid = CoverOfRays(frame, plan, drawn.coverGrid);
  this->boxes.Draw(frame, plan, drawn);
}

std::vector<std::vector<float>> ShaderMarcher::DrawTrials(
  const Frame& frame, const std::vector<MarchPlan>& plans)
{
  std::vector<std::vector<float>> drawn;
  for (const MarchPlan& plan : plans)
  {
    this->trial.Draw(frame.view.window, plan.viewport, [&] { this->Draw(frame, plan); });
    drawn.push_back(this->trial.Read(frame.view.window, plan.viewport));
  }
  return drawn;
}

void ShaderMarcher::Release(vtkWindow* window)
{
  this->blocks.Release(window);
  this->trial.Release(window);
}

}
