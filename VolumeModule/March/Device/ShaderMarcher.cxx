#include "March/Device/ShaderMarcher.h"

#include "vtkOpenGLRenderWindow.h"

namespace varimarch
{

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
