#include "March/PassMarch.h"

#include "March/RayParametersBuilder.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace varimarch
{

void PassMarch::Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  if (this->resources.IsInBlocks())
  {
    throw std::runtime_error("A volume in blocks cannot be drawn between translucent geometry or "
                             "selected: the maximum graphics memory, or the device's 3D textures, "
                             "are too small for it");
  }
  marcher.Draw(frame, plan);
}

void PassMarch::DrawImages(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  const Viewport rays = RaysOf(plan.viewport, plan.imageSampleDistance);
  const MarchPlan images = plan.WithPass(RayPass::PictureAndDepth).WithViewport(rays);
  this->images.Draw(frame.view.window, rays, [&] { this->Draw(frame, images, marcher); });
  this->imagePixels = rays;
}

std::vector<float> PassMarch::ColorImage(vtkOpenGLRenderWindow* window)
{
  return this->images.Read(window, this->imagePixels, 0);
}

std::vector<float> PassMarch::DepthImage(vtkOpenGLRenderWindow* window)
{
  return this->images.Read(window, this->imagePixels, 1);
}

void PassMarch::Release(vtkWindow* window)
{
  this->images.Release(window);
  this->imagePixels = {};
}

void FillColorImage(const std::vector<float>& rgba, int width, int height, vtkImageData* image)
{
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < rgba.size(); ++i)
  {
    const float white = i % 4 == 3 ? 0.0f : 1.0f - rgba[i | 3];
    bytes[i] =
      static_cast<unsigned char>(std::lround(255.0f * std::clamp(rgba[i] + white, 0.0f, 1.0f)));
  }
}

void FillDepthImage(
  const std::vector<float>& rgba, int width, int height, int scalarType, vtkImageData* image)
{
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* const depths = image->GetPointData()->GetScalars();
  const bool integers = scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE;
  for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
  {
    const double depth = 1.0 - rgba[4 * i];
    depths->SetComponent(i, 0, integers ? std::round(depth * depths->GetDataTypeMax()) : depth);
  }
}

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
