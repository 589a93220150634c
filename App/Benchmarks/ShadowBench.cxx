#include "ShadowBench.h"

#include "CommandLine/VtkMessages.h"
#include "Scene/Median.h"
#include "Scene/OffscreenView.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr int FramesOfMotion = 9;

/// A view, with or without shadows, and what is measured in it.
struct ShadowView
{
  OffscreenView view;
  SceneLight light;
  double firstMs;

  ShadowView(const Scene& scene, vtkImageData* image)
    : view(scene, image, MapperKind::Varimarch)
    , light(scene.lights.front())
    , firstMs(1000.0 * this->view.Render())
  {
  }

  double MedianMs(ShadowMotion motion)
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
  void Move(ShadowMotion motion)
  {
    if (motion == ShadowMotion::Turning)
    {
      this->view.Pipeline().Renderer()->GetActiveCamera()->Azimuth(1.0);
      this->view.Pipeline().Renderer()->ResetCameraClippingRange();
    }
    if (motion == ShadowMotion::LightDragged)
    {
      this->light = Turned(this->light, 2.0);
      this->view.Pipeline().SetLights({ this->light });
    }
  }
};

// The times of each round, one list for each motion.
struct Rounds
{
  std::array<std::vector<double>, ShadowMotions> without;
  std::array<std::vector<double>, ShadowMotions> with;
  std::array<std::vector<double>, ShadowMotions> factor;

  // A slow moment of the machine affects both alike.
  void Add(int round, ShadowView& plain, ShadowView& shadowed)
  {
    for (int motion = 0; motion < ShadowMotions; ++motion)
    {
      const auto drawPlain = [&]
      { this->without[motion].push_back(plain.MedianMs(ShadowMotion(motion))); };
      const auto drawShadowed = [&]
      { this->with[motion].push_back(shadowed.MedianMs(ShadowMotion(motion))); };
      if (round % 2 == 0)
      {
        drawPlain();
      }
      drawShadowed();
      if (round % 2 == 1)
      {
        drawPlain();
      }
      this->factor[motion].push_back(this->with[motion].back() / this->without[motion].back());
    }
  }
};

ImageError ErrorOf(const Scene& scene, vtkImageData* image)
{
  OffscreenView drawn(scene, image, MapperKind::Varimarch);
  OffscreenView exact(FineScene(scene, scene.render.errorTolerance), image, MapperKind::Varimarch);
  const std::vector<float> pixels = PixelsOf(drawn);
  return CompareImages(pixels.data(), PixelsOf(exact).data(), pixels.size() / 4);
}

}

ShadowCase MeasureShadows(
  const LoadedScene& loaded, const ShadowOptions& options, const OnStep& onStep)
{
  const Scene plain = LitScene(loaded, options);
  const Scene shadowed = WithShadows(plain);
  ShadowCase measured = { loaded.name };
  Rounds rounds;
  std::vector<double> firstMs;
  for (int round = 0; round < options.rounds; ++round)
  {
    onStep("times, round " + std::to_string(round + 1));
    ShadowView without(plain, loaded.volume.image);
    ShadowView with(shadowed, loaded.volume.image);
    firstMs.push_back(with.firstMs);
    rounds.Add(round, without, with);
  }
  measured.firstMs = Median(firstMs);
  for (int motion = 0; motion < ShadowMotions; ++motion)
  {
    measured.withoutMs[motion] = Median(rounds.without[motion]);
    measured.withMs[motion] = Median(rounds.with[motion]);
    measured.factor[motion] = Median(rounds.factor[motion]);
  }
  onStep("error");
  measured.error = ErrorOf(shadowed, loaded.volume.image);
  ThrowIfVtkReportedError();
  return measured;
}

double MeanFactor(const std::vector<ShadowCase>& cases, ShadowMotion motion)
{
  double sum = 0.0;
  for (const ShadowCase& measured : cases)
  {
    sum += std::log(measured.factor[int(motion)]);
  }
  return std::exp(sum / double(cases.size()));
}

}
