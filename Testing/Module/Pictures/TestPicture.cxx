// Settings of the whole image: window and level, number of rays and jitter.

#include "Module/Scenes/HomogeneousScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using Rgba = std::array<double, 4>;

void ExpectPixel(
  const std::vector<float>& picture, int size, int x, int y, const Rgba& truth, double tolerance)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(picture[4 * (y * size + x) + channel], truth[channel], tolerance)
      << "pixel " << x << ", " << y << ", channel " << channel;
  }
}

// An oblique sheet thinner than the sample distance, which causes stripes.
void MakeStripes(MapperScene& scene)
{
  for (int z = 0; z < 17; ++z)
  {
    for (int y = 0; y < 17; ++y)
    {
      for (int x = 0; x < 17; ++x)
      {
        scene.image->SetScalarComponentFromDouble(x, y, z, 0, z + 0.1 * x + 0.08 * y);
      }
    }
  }
  scene.image->Modified();
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(12.9, 0.0);
  scene.opacities->AddPoint(13.0, 0.1);
  scene.opacities->AddPoint(13.1, 0.0);
  scene.volume->GetProperty()->SetScalarOpacity(scene.opacities);
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.45);
}

// Root mean square difference of two images, each averaged over squares of pixels: this preserves
// stripes and removes grain.
double CoarseDifference(const std::vector<float>& one, const std::vector<float>& other, int size)
{
  constexpr int Square = 8;
  double sum = 0.0;
  for (int top = 0; top < size; top += Square)
  {
    for (int left = 0; left < size; left += Square)
    {
      double mean = 0.0;
      for (int i = 0; i < Square * Square; ++i)
      {
        const std::size_t pixel = std::size_t(top + i / Square) * size + left + i % Square;
        mean += (double(one[4 * pixel + 3]) - other[4 * pixel + 3]) / (Square * Square);
      }
      sum += mean * mean;
    }
  }
  return std::sqrt(sum * Square * Square / (size * size));
}

}

TEST(Window, ScalesColoursBetweenNothingAndOpacity)
{
  HomogeneousScene scene;
  const Rgba plain = scene.Piece(HomogeneousScene::SideMm);
  for (const auto& [window, level] :
    { std::pair(0.5, 0.6), std::pair(2.0, 0.5), std::pair(-1.0, 0.5), std::pair(0.1, 0.1) })
  {
    scene.mapper->SetFinalColorWindow(float(window));
    scene.mapper->SetFinalColorLevel(float(level));
    Rgba expected = plain;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double shown = (scene.rgb[channel] - level) / window + 0.5;
      expected[channel] = plain[3] * std::clamp(shown, 0.0, 1.0);
    }
    ExpectPixel(scene.Draw(), scene.size, 16, 16, expected, 1e-5);
  }
}

TEST(Window, AppliesToAVolumeInBlocks)
{
  MapperScene scene(SmallTorso(), 32);
  scene.Draw();
  scene.mapper->SetMaximumGraphicsMemory(scene.mapper->GetGraphicsMemoryBytes() - 1);
  const std::vector<float> plain = scene.Draw();
  scene.mapper->SetFinalColorWindow(0.5f);
  const std::vector<float> windowed = scene.Draw();
  ASSERT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    const float alpha = plain[i | 3];
    const float scaled = std::clamp(2.0f * plain[i] - 0.5f * alpha, 0.0f, alpha);
    EXPECT_NEAR(windowed[i], i % 4 == 3 ? alpha : scaled, 1e-5);
  }
}

TEST(Jitter, KeepsTheLengthOfRays)
{
  HomogeneousScene scene;
  scene.mapper->UseJitteringOn();
  for (int acceleration : { 0, 1, 2 })
  {
    scene.mapper->SetAccelerationMode(acceleration);
    const std::vector<float> drawn = scene.Draw();
    for (int pixel = 0; pixel < 32; ++pixel)
    {
      ExpectPixel(drawn, 32, pixel, 31 - pixel, scene.Piece(HomogeneousScene::SideMm), 1e-4);
    }
  }
}

TEST(Jitter, IsTheSameInEveryPicture)
{
  HomogeneousScene scene(0.1, 64);
  MakeStripes(scene);
  scene.mapper->UseJitteringOn();
  EXPECT_EQ(scene.Draw(), scene.Draw());
}

TEST(Jitter, TurnsStripesIntoAGrain)
{
  HomogeneousScene scene(0.1, 64);
  MakeStripes(scene);
  const std::vector<float> stripes = scene.Draw();
  scene.mapper->UseJitteringOn();
  const std::vector<float> grain = scene.Draw();
  const std::vector<float> truth = scene.Truth(1e-4);
  EXPECT_LT(CoarseDifference(grain, truth, 64), 0.5 * CoarseDifference(stripes, truth, 64));
}

TEST(ImageSampleDistance, KeepsWhatIsHomogeneousWithFewerRaysAndMore)
{
  HomogeneousScene scene;
  const Rgba truth = scene.Piece(HomogeneousScene::SideMm);
  for (float distance : { 0.5f, 0.33f, 1.5f, 2.0f, 4.0f })
  {
    scene.mapper->SetImageSampleDistance(distance);
    const std::vector<float> drawn = scene.Draw();
    for (int pixel = 0; pixel < 32; ++pixel)
    {
      ExpectPixel(drawn, 32, pixel, (7 * pixel) % 32, truth, 1e-4);
    }
  }
}

TEST(ImageSampleDistance, KeepsTheEdgesOfOpaqueGeometry)
{
  HomogeneousScene scene;
  const std::array<double, 3> black = { 0.0, 0.0, 0.0 };
  scene.renderer->AddActor(Plane(4.0, 1.3, black));
  const Rgba covered = Over(scene.Piece(4.0), { 0.0, 0.0, 0.0, 1.0 });
  const Rgba open = scene.Piece(HomogeneousScene::SideMm);
  for (float distance : { 0.5f, 2.0f, 4.0f })
  {
    scene.mapper->SetImageSampleDistance(distance);
    const std::vector<float> drawn = scene.Draw();
    for (int x = 0; x < 32; ++x)
    {
      const double xMm = ((x + 0.5) / 32.0 - 0.5) * 0.98 * HomogeneousScene::SideMm;
      ExpectPixel(drawn, 32, x, 16, xMm > 1.3 ? covered : open, 4e-3);
    }
  }
}

TEST(ImageSampleDistance, IsCloserToTheTruthThanLinearInterpolation)
{
  MapperScene scene(SmallTorso(), 96);
  const std::vector<float> full = scene.Draw();
  scene.mapper->SetImageSampleDistance(2.0f);
  const std::vector<float> half = scene.Draw();
  // The image of a quarter of the rays, linearly interpolated by the test.
  MapperScene quarter(SmallTorso(), 48);
  const std::vector<float> small = quarter.Draw();
  std::vector<float> linear(full.size());
  for (int pixel = 0; pixel < 96 * 96; ++pixel)
  {
    const double x = std::clamp((pixel % 96 + 0.5) / 2.0 - 0.5, 0.0, 46.999);
    const double y = std::clamp((pixel / 96 + 0.5) / 2.0 - 0.5, 0.0, 46.999);
    for (int channel = 0; channel < 4; ++channel)
    {
      const auto at = [&](int column, int row) { return small[4 * (row * 48 + column) + channel]; };
      const double fx = x - int(x);
      const double fy = y - int(y);
      linear[4 * pixel + channel] =
        float((1 - fy) * ((1 - fx) * at(int(x), int(y)) + fx * at(int(x) + 1, int(y))) +
          fy * ((1 - fx) * at(int(x), int(y) + 1) + fx * at(int(x) + 1, int(y) + 1)));
    }
  }
  const auto error = [&](const std::vector<float>& picture)
  { return varimarch::CompareImages(picture.data(), full.data(), 96 * 96).rootMeanSquare; };
  EXPECT_LT(error(half), 0.9 * error(linear)) << error(linear);
}

TEST(Resources, ImagesAreKeptOnlyWhileTheyAreUsed)
{
  HomogeneousScene scene;
  scene.window->Render();
  const vtkIdType plain = scene.mapper->GetGraphicsMemoryBytes();
  const std::vector<std::string> plainParts = scene.ShaderParts();
  EXPECT_TRUE(scene.UsesShaderPart("Jitter/None.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("Window/None.glsl"));

  scene.mapper->UseJitteringOn();
  scene.mapper->SetFinalColorLevel(0.4f);
  scene.mapper->SetImageSampleDistance(2.0f);
  scene.window->Render();
  const vtkIdType noise = 64 * 64 * 2;
  const vtkIdType rays = 16 * 16 * 16;
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), plain + noise + rays);
  EXPECT_TRUE(scene.UsesShaderPart("Jitter/BlueNoise.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("Window/WindowLevel.glsl"));

  scene.mapper->UseJitteringOff();
  scene.mapper->SetFinalColorLevel(0.5f);
  scene.mapper->SetImageSampleDistance(1.0f);
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), plain);
  EXPECT_EQ(scene.ShaderParts(), plainParts);
}
