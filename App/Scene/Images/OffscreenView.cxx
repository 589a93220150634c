#include "Scene/Images/OffscreenView.h"

#include "Scene/Images/EmptyPicture.h"
#include "Scene/Images/FloatCapture.h"

#include <vtkVariationFieldVolumeMapper.h>
#include <vtkWindowToImageFilter.h>

#include <chrono>
#include <stdexcept>

namespace varimarch
{

OffscreenView::OffscreenView(const Scene& scene, vtkImageData* image, MapperKind kind)
  : pipeline(scene, image, kind)
{
  if (!this->window->InitializeContext())
  {
    throw std::runtime_error(this->window->GetFailureReason());
  }
  this->window->SetSize(scene.size[0], scene.size[1]);
  this->window->AddRenderer(this->pipeline.Renderer());
}

double OffscreenView::Render()
{
  const auto start = std::chrono::steady_clock::now();
  this->window->Render();
  this->window->WaitForCompletion();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

std::optional<double> OffscreenView::RenderWhile(const std::function<bool()>& isWanted)
{
  bool isStopped = false;
  const StopCheck check(this->window,
    [&]
    {
      isStopped = isStopped || !isWanted();
      return !isStopped;
    });
  const double seconds = this->Render();
  return isStopped ? std::nullopt : std::optional(seconds);
}

double OffscreenView::RenderAll(const std::function<void(double)>& onImage)
{
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->pipeline.Mapper());
  double seconds = 0.0;
  do
  {
    seconds += this->Render();
    if (onImage)
    {
      onImage(seconds);
    }
  } while (ours && ours->GetDrawnPart() < 1.0);
  return seconds;
}

vtkSmartPointer<vtkImageData> OffscreenView::Bytes()
{
  vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(this->window);
  reader->ReadFrontBufferOff();
  reader->ShouldRerenderOff();
  reader->Update();
  return reader->GetOutput();
}

std::string OffscreenView::ReasonForNothing(const Scene& scene)
{
  return varimarch::ReasonForNothing(BytesOf(this->window), this->pipeline, scene);
}

// Each image takes more voxels in place of the coarse level, so that bands of the first ones would
// differ.
vtkSmartPointer<vtkImageData> OffscreenView::FloatImage(const std::function<bool(double)>& onBand)
{
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->pipeline.Mapper());
  if (ours && ours->GetLevelOfDetail() == vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    const auto isWanted = [&] { return !onBand || onBand(0.0); };
    do
    {
      if (!this->RenderWhile(isWanted) || !isWanted())
      {
        return nullptr;
      }
    } while (ours->GetDrawnPart() < 1.0);
  }
  return CaptureFloatImage(this->window, this->pipeline.Renderer(), onBand);
}

}
