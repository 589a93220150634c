#include "OrbitChange.h"

#include "Core/Quality/ImageError.h"
#include "Scene/Median.h"

#include <vtkCamera.h>

#include <algorithm>

namespace varimarch
{

namespace
{

using Pixels = std::vector<float>;

void Turn(MethodView& view, double degrees)
{
  vtkRenderer* const renderer = view.Offscreen().Pipeline().Renderer();
  renderer->GetActiveCamera()->Azimuth(degrees);
  renderer->ResetCameraClippingRange();
}

Pixels PixelsOf(MethodView& view)
{
  const auto picture = view.Offscreen().FloatImage();
  const auto* const channels = static_cast<const float*>(picture->GetScalarPointer());
  return Pixels(channels, channels + 4 * picture->GetNumberOfPoints());
}

Pixels Less(Pixels pixels, const Pixels& fine)
{
  std::transform(pixels.begin(), pixels.end(), fine.begin(), pixels.begin(), std::minus<float>());
  return pixels;
}

RenderOptions FineOptions(vtkImageData* image)
{
  RenderOptions options;
  options.earlyTerminationTransmittance = 0.0;
  return AtDistance(image, 0.125, options).options;
}

// A method on its way through an orbit.
struct OrbitingView
{
  MethodView* view;
  Pixels error; ///< the error of the last frame; empty before the first
  std::vector<double> changes;

  void TakeFrame(const Pixels& fine)
  {
    Pixels next = Less(PixelsOf(*this->view), fine);
    if (!this->error.empty())
    {
      this->changes.push_back(
        CompareImages(next.data(), this->error.data(), next.size() / 4).rootMeanSquare);
    }
    this->error = std::move(next);
  }
};

}

std::vector<OrbitChange> ChangesInOrbit(const std::vector<MethodView*>& views, const Scene& scene,
  vtkImageData* image, int frames, const OnStep& onStep)
{
  MethodView fineView({ "fine", "fine frames", MapperKind::Varimarch, {} }, scene, image);
  fineView.SetOptions(FineOptions(image));
  const double degrees = OrbitDegrees / (frames - 1);
  std::vector<OrbitingView> orbiting;
  for (MethodView* const view : views)
  {
    view->Offscreen().Render(); // VTK's GPU mapper draws its first frame only into the window
    orbiting.push_back({ view, {}, {} });
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    onStep("frame " + std::to_string(frame + 1) + " of " + std::to_string(frames) + " of an orbit");
    const Pixels fine = PixelsOf(fineView);
    for (OrbitingView& one : orbiting)
    {
      one.TakeFrame(fine);
      Turn(*one.view, frame + 1 < frames ? degrees : -OrbitDegrees);
    }
    Turn(fineView, degrees);
  }
  std::vector<OrbitChange> summaries;
  for (const OrbitingView& one : orbiting)
  {
    summaries.push_back(SummaryOf(one.changes));
  }
  return summaries;
}

OrbitChange SummaryOf(const std::vector<double>& changes)
{
  const auto largest = std::max_element(changes.begin(), changes.end());
  const int frames = int(changes.size()) + 1;
  const double degrees = OrbitDegrees / double(changes.size());
  return { frames, degrees, Median(changes), *largest,
    degrees * double(largest - changes.begin() + 1) };
}

}
