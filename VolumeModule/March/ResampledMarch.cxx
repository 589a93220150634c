#include "March/ResampledMarch.h"

#include "March/RayParametersBuilder.h"

#include "vtkOpenGLRenderWindow.h"

namespace varimarch
{

void ResampledMarch::Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  const Viewport rayPixels = RaysOf(plan.viewport, plan.imageSampleDistance);
  this->rays.Draw(
    frame.view.window, rayPixels, [&] { marcher.Draw(frame, plan.WithViewport(rayPixels)); });
  const RayPass pass =
    rayPixels.width > plan.viewport.width ? RayPass::Averaged : RayPass::Upscaled;
  EarlierDrawings earlier;
  earlier.coarse = this->rays.Texture();
  this->boxes.Draw(
    frame, plan.WithPass(pass), AllThatIsVisible(this->resources.DrawnBox()), earlier);
}

}
