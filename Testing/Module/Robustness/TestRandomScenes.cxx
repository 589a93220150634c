// Scenes that are made up by chance keep the mapper's promise, judged by the reference integrator.
//
// VARIMARCH_RANDOM_SCENES is the number of scenes, VARIMARCH_RANDOM_SEED the first seed. A scene
// that fails is drawn alone by its seed and the number 1.

#include "Module/Scenes/Dice.h"
#include "Module/Scenes/RandomScenes.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

// The suite draws this many scenes in about 10 s of one core.
constexpr long UsualScenes = 150;

// The larger of an error in a channel of a pixel, for bounds of what is right.
double ErrorOf(const float* pixel, const float* lower, const float* upper)
{
  double error = 0.0;
  for (int channel = 0; channel < 4; ++channel)
  {
    const double below = double(lower[channel]) - pixel[channel];
    const double above = double(pixel[channel]) - upper[channel];
    error = std::max({ error, below, above });
  }
  return error;
}

struct Judged
{
  int off = 0;           ///< pixels that are off by more than the tolerance
  int offEverywhere = 0; ///< pixels that no ray within a tenth of a pixel explains
  double largest = 0.0;  ///< the largest error of these [tolerances]
};

struct Bounds
{
  std::vector<float> lower;
  std::vector<float> upper;
};

Judged JudgedBy(const Bounds& bounds, const std::vector<float>& drawn, double tolerance)
{
  Judged judged;
  for (std::size_t pixel = 0; pixel < drawn.size(); pixel += 4)
  {
    const double error = ErrorOf(&drawn[pixel], &bounds.lower[pixel], &bounds.upper[pixel]);
    judged.off += error > tolerance;
    judged.largest = std::max(judged.largest, error / tolerance);
  }
  judged.offEverywhere = judged.off;
  return judged;
}

// A pixel at a discontinuity is right if a ray beside it has the same colour.
Judged Judge(RandomScene& scene, const std::vector<float>& drawn)
{
  const double tolerance = scene.Scene().mapper->GetErrorTolerance();
  const std::vector<float> truth = scene.Truth();
  Bounds bounds{ truth, truth };
  const Judged first = JudgedBy(bounds, drawn, tolerance);
  if (first.off == 0)
  {
    return first;
  }
  vtkCamera* const camera = scene.Scene().renderer->GetActiveCamera();
  constexpr int Directions = 8;
  for (int i = 0; i < Directions; ++i)
  {
    const double angle = 6.2831853 * i / Directions;
    const double shift = 2.0 * 0.1 / scene.Scene().size;
    camera->SetWindowCenter(shift * std::cos(angle), shift * std::sin(angle));
    const std::vector<float> beside = scene.Truth();
    for (std::size_t k = 0; k < beside.size(); ++k)
    {
      bounds.lower[k] = std::min(bounds.lower[k], beside[k]);
      bounds.upper[k] = std::max(bounds.upper[k], beside[k]);
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  const Judged second = JudgedBy(bounds, drawn, tolerance);
  return { first.off, second.off, second.largest };
}

// A thousandth of 48 x 48 pixels may be off, by twice the tolerance, and one where rays graze edges
// by more. There a hundredth may be right only for a ray beside theirs. More rays graze opaque and
// far values: an opaque end of a ramp begins up to one entry of the table too early, and the
// corners of cells beside limited far values are rounded.
bool KeepsPromise(const Judged& judged, RandomEdges edges)
{
  constexpr int Hundredth = 23;
  const bool isHard = edges == RandomEdges::Hard;
  const bool hasEdges = edges != RandomEdges::None;
  const int mostOff = judged.largest <= 2.0 ? (isHard ? Hundredth : 3) : (isHard ? 6 : hasEdges);
  return judged.offEverywhere <= mostOff && judged.off <= (hasEdges ? Hundredth : 5);
}

bool IsPicture(const std::vector<float>& drawn)
{
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const float most = i % 4 == 3 ? 1.0f : 10.0f; // light may be brighter than white
    if (!(drawn[i] >= 0.0f && drawn[i] <= most))
    {
      return false;
    }
  }
  return true;
}

}

TEST(RandomScenes, KeepTheirErrorToleranceOrWarn)
{
  const long count = NumberFromEnvironment("VARIMARCH_RANDOM_SCENES", UsualScenes);
  const long first = NumberFromEnvironment("VARIMARCH_RANDOM_SEED", 1);
  vtkNew<vtkHeadlessRenderWindow> window;
  long warned = 0;
  for (long seed = first; seed < first + count; ++seed)
  {
    RandomScene scene(std::uint64_t(seed), window);
    ExpectedVtkErrors messages;
    const std::vector<float> drawn = scene.Draw();
    EXPECT_EQ(messages.Text().find("ERROR"), std::string::npos) << scene.Description() << "\n"
                                                                << messages.Text();
    EXPECT_TRUE(IsPicture(drawn)) << scene.Description();
    if (!messages.Messages().empty() || !scene.IsExact())
    {
      ++warned;
      continue;
    }
    const Judged judged = Judge(scene, drawn);
    EXPECT_TRUE(KeepsPromise(judged, scene.Edges()))
      << judged.off << " pixels are off, " << judged.offEverywhere
      << " with all rays beside them, by up to " << judged.largest << " tolerances; "
      << scene.Description();
  }
  EXPECT_LE(warned, std::max(count / 5, 2L)) << "so many scenes are not judged";
}
