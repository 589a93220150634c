#include "ImageOfProcesses.h"

#include "OrderOfProcesses.h"
#include "vtkVarimarchFloatPass.h"

#include "vtkBoundingBox.h"
#include "vtkCameraPass.h"
#include "vtkIceTCompositePass.h"
#include "vtkMultiProcessController.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkValuePass.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

// True if ParaView draws a still image and not one of those during an interaction, for which it
// asks for 5 images per second.
bool IsStill(vtkRenderer* renderer)
{
  constexpr double LowestInteractiveRate = 1.0;
  return renderer->GetRenderWindow()->GetDesiredUpdateRate() < LowestInteractiveRate;
}

// True if a pass composites the colours of one image, which is shown in one window.
bool CompositesOneImage(vtkIceTCompositePass* pass)
{
  const int* const tiles = pass->GetTileDimensions();
  return tiles[0] * tiles[1] == 1 && pass->GetUseOrderedCompositing() &&
    !pass->GetDataReplicatedOnAllProcesses() && !vtkValuePass::SafeDownCast(pass->GetRenderPass());
}

std::string WarningOf(const std::pair<int, int>& conflict)
{
  return "The processes " + std::to_string(conflict.first) + " and " +
    std::to_string(conflict.second) +
    ", or others between them, have parts in front of each other, and ParaView, which lays the "
    "pictures of processes over each other as a whole, draws some pixels wrongly: no order of "
    "processes is right for this view; expected another view, one volume, or one process.";
}

}

ImageOfProcesses::ImageOfProcesses() = default;

ImageOfProcesses::~ImageOfProcesses() = default;

bool ImageOfProcesses::MayBeInFloats(vtkRenderer* renderer)
{
  if (!IsStill(renderer) || renderer->GetSelector())
  {
    return false;
  }
  vtkIceTCompositePass* const pass = CompositePassOf(renderer);
  return pass ? CompositesOneImage(pass)
              : UsualCameraPassOf(renderer) && renderer->GetRenderWindow()->GetMultiSamples() < 2;
}

std::string ImageOfProcesses::Begin(vtkRenderer* renderer, vtkMultiProcessController* controller,
  const OwnerOrder& order, bool inFloats)
{
  this->End();
  vtkIceTCompositePass* const pass = CompositePassOf(renderer);
  vtkOrderedCompositingHelper* const helper = pass ? pass->GetOrderedCompositingHelper() : nullptr;
  if (!helper)
  {
    return {};
  }
  std::vector<int> shown = order.owners;
  if (inFloats)
  {
    this->floatPass->Begin(renderer, pass, controller, order.owners);
    // One process has the whole image, so that any order is right; ParaView finds this one fastest.
    std::sort(shown.begin(), shown.end());
  }
  helper->SetBoundingBoxes(BoxesInOrder(shown, renderer->GetActiveCamera()));
  const bool warns = order.conflict && !this->hasWarned;
  this->hasWarned = this->hasWarned || warns;
  return warns ? WarningOf(*order.conflict) : std::string();
}

void ImageOfProcesses::BeginAlone(vtkRenderer* renderer)
{
  this->End();
  this->floatPass->BeginAlone(UsualCameraPassOf(renderer));
}

void ImageOfProcesses::SetFile(const std::string& file)
{
  this->floatPass->SetImageFile(file);
}

void ImageOfProcesses::End()
{
  this->floatPass->End();
}

}
