#include "LightCost.h"

#include "CommandLine/VtkMessages.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"
#include "Scene/SceneLights.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr int FramesOfMotion = 9;

/// A view, with or without the feature, and what is measured in it.
struct MeasuredView
{
  OffscreenView view;
  Lighting lighting;
  double firstMs;

  MeasuredView(const Scene& scene, vtkImageData* image)
    : view(scene, image, MapperKind::Varimarch)
    , lighting(LightingOf(scene))
    , firstMs(1000.0 * this->view.Render())
  {
  }

  double MedianMs(LightMotion motion)
  {
    std::vector<double> times;
    for (int frame = 0; frame < FramesOfMotion; ++frame)
    {
      this->Move(motion);
      times.push_back(1000.0 * this->view.Render());
    }
    return Median(times);
  }

private:
  void Move(LightMotion motion)
  {
    if (motion == LightMotion::Turning)
    {
      this->view.Pipeline().Renderer()->GetActiveCamera()->Azimuth(1.0);
      this->view.Pipeline().Renderer()->ResetCameraClippingRange();
    }
    if (motion == LightMotion::LightDragged)
    {
      this->lighting.lights = { Turned(this->lighting.lights.front(), 2.0) };
      this->lighting.occlusion.strength *= 0.98;
      this->view.Pipeline().SetLighting(this->lighting);
    }
  }
};

// The times of each round, one list for each motion.
struct Rounds
{
  std::array<std::vector<double>, LightMotions> without;
  std::array<std::vector<double>, LightMotions> with;
  std::array<std::vector<double>, LightMotions> factor;

  // A slow moment of the machine affects both alike.
  void Add(int round, MeasuredView& plain, MeasuredView& featured)
  {
    for (int motion = 0; motion < LightMotions; ++motion)
    {
      const auto drawPlain = [&]
      { this->without[motion].push_back(plain.MedianMs(LightMotion(motion))); };
      const auto drawWith = [&]
      { this->with[motion].push_back(featured.MedianMs(LightMotion(motion))); };
      if (round % 2 == 0)
      {
        drawPlain();
      }
      drawWith();
      if (round % 2 == 1)
      {
        drawPlain();
      }
      this->factor[motion].push_back(this->with[motion].back() / this->without[motion].back());
    }
  }
};

ImageError ErrorAgainstReference(const Scene& scene, vtkImageData* image)
{
  OffscreenView drawn(scene, image, MapperKind::Varimarch);
  OffscreenView exact(FineScene(scene, scene.render.errorTolerance), image, MapperKind::Varimarch);
  const std::vector<float> pixels = PixelsOf(drawn);
  return CompareImages(pixels.data(), PixelsOf(exact).data(), pixels.size() / 4);
}

}

LightCost MeasureLightCost(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  const Scene plain = LitScene(loaded, options);
  const Scene featured = WithFeature(plain, options.feature);
  LightCost measured = { loaded.name };
  Rounds rounds;
  std::vector<double> firstMs;
  for (int round = 0; round < options.rounds; ++round)
  {
    onStep("times, round " + std::to_string(round + 1));
    MeasuredView without(plain, loaded.volume.image);
    MeasuredView with(featured, loaded.volume.image);
    firstMs.push_back(with.firstMs);
    rounds.Add(round, without, with);
  }
  measured.firstMs = Median(firstMs);
  for (int motion = 0; motion < LightMotions; ++motion)
  {
    measured.withoutMs[motion] = Median(rounds.without[motion]);
    measured.withMs[motion] = Median(rounds.with[motion]);
    measured.factor[motion] = Median(rounds.factor[motion]);
  }
  onStep("error");
  measured.error = ErrorAgainstReference(featured, loaded.volume.image);
  ThrowIfVtkReportedError();
  return measured;
}

double MeanFactor(const std::vector<LightCost>& cases, LightMotion motion)
{
  double sum = 0.0;
  for (const LightCost& measured : cases)
  {
    sum += std::log(measured.factor[int(motion)]);
  }
  return std::exp(sum / double(cases.size()));
}

}
