#include "PictureVerdict.h"

#include "Judge.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace varimarch
{

namespace
{

// The largest difference of a channel; light brighter than white is white.
double Difference(glm::dvec4 one, glm::dvec4 other)
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double difference = std::abs(std::min(one[i], 1.0) - std::min(other[i], 1.0));
    largest = std::isfinite(difference) ? std::max(largest, difference)
                                        : std::numeric_limits<double>::infinity();
  }
  return largest;
}

struct JudgedPixel
{
  glm::dvec4 color;
  double error;           ///< error of the picture
  double doubt;           ///< error of the judge
  bool isRefined = false; ///< judged by two finenesses
};

class Pixels
{
public:
  Pixels(const JudgeScene& scene, const std::vector<float>& drawn, const std::vector<float>& behind)
    : scene(scene)
    , judge(scene)
    , drawn(drawn)
    , behind(behind)
    , pixels(drawn.size() / 4)
  {
  }

  void JudgeAll();

  /// Judges pixels finer, until the judge knows them.
  void Refine(const std::vector<std::size_t>& chosen);

  bool IsBeyond(std::size_t i) const
  {
    const JudgedPixel& one = this->pixels[i];
    return one.isRefined && one.error - one.doubt > this->scene.errorTolerance;
  }
  bool IsDoubtful(std::size_t i) const
  {
    const JudgedPixel& one = this->pixels[i];
    return one.isRefined && !this->IsBeyond(i) &&
      one.error + one.doubt > this->scene.errorTolerance;
  }
  const JudgedPixel& operator[](std::size_t i) const { return this->pixels[i]; }
  std::size_t Count() const { return this->pixels.size(); }

  /// The largest difference that refinement has made to one of these pixels.
  double LargestChange(const std::vector<std::size_t>& chosen) const;

private:
  glm::dvec2 PlaceOf(std::size_t i) const
  {
    return { double(i % std::size_t(this->scene.width)) + 0.5,
      double(i / std::size_t(this->scene.width)) + 0.5 };
  }
  glm::dvec4 Drawn(std::size_t i) const { return glm::make_vec4(&this->drawn[4 * i]); }
  glm::dvec4 ColorAt(std::size_t i, glm::dvec2 shift, int fineness) const;
  void RefineOne(std::size_t i);
  double ErrorBeside(std::size_t i, int fineness) const;

  const JudgeScene& scene;
  Judge judge;
  const std::vector<float>& drawn;
  const std::vector<float>& behind;
  std::vector<JudgedPixel> pixels;
  std::vector<glm::dvec4> coarse;
};

glm::dvec4 Pixels::ColorAt(std::size_t i, glm::dvec2 shift, int fineness) const
{
  const glm::dvec4 volumes = this->judge.Pixel(this->PlaceOf(i) + shift, fineness);
  const glm::dvec4 others = glm::make_vec4(&this->behind[4 * i]);
  return volumes + (1.0 - volumes.a) * others;
}

void Pixels::JudgeAll()
{
  tbb::parallel_for(std::size_t(0), this->pixels.size(),
    [&](std::size_t i)
    {
      JudgedPixel& one = this->pixels[i];
      one.color = this->ColorAt(i, glm::dvec2(0.0), Judge::Coarse);
      one.error = Difference(one.color, this->Drawn(i));
      one.doubt = 0.0;
    });
  for (const JudgedPixel& one : this->pixels)
  {
    this->coarse.push_back(one.color);
  }
}

void Pixels::RefineOne(std::size_t i)
{
  constexpr int Finest = 8;
  constexpr double Known = 0.05; // a part of the tolerance
  const double tolerance = this->scene.errorTolerance;
  JudgedPixel& one = this->pixels[i];
  int fineness = Judge::Coarse;
  bool isKnown = false;
  // A pixel is beyond the tolerance only by the finest judgement.
  while ((!isKnown || one.error > tolerance) && fineness < Finest)
  {
    fineness = fineness == Judge::Coarse ? 1 : 2 * fineness;
    const glm::dvec4 finer = this->ColorAt(i, glm::dvec2(0.0), fineness);
    one.doubt = Difference(one.color, finer);
    one.color = finer;
    one.error = Difference(finer, this->Drawn(i));
    isKnown = one.doubt < Known * tolerance || std::abs(one.error - tolerance) > 3.0 * one.doubt;
  }
  one.isRefined = true;
  if (one.error > tolerance)
  {
    one.error = std::min(one.error, this->ErrorBeside(i, fineness));
  }
}

// The mapper's rays are floats: a pixel is also right if it is right for a ray that is off by a
// thousandth of a pixel, or between two of these.
double Pixels::ErrorBeside(std::size_t i, int fineness) const
{
  constexpr double Shift = 1e-3; // [pixels]
  glm::dvec4 lower = this->pixels[i].color;
  glm::dvec4 upper = lower;
  for (const glm::dvec2 shift :
    { glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1) })
  {
    const glm::dvec4 beside = this->ColorAt(i, Shift * shift, fineness);
    lower = glm::min(lower, beside);
    upper = glm::max(upper, beside);
  }
  const glm::dvec4 drawn = this->Drawn(i);
  return Difference(drawn, glm::clamp(drawn, lower, upper));
}

void Pixels::Refine(const std::vector<std::size_t>& chosen)
{
  tbb::parallel_for(std::size_t(0), chosen.size(),
    [&](std::size_t k)
    {
      if (!this->pixels[chosen[k]].isRefined)
      {
        this->RefineOne(chosen[k]);
      }
    });
}

double Pixels::LargestChange(const std::vector<std::size_t>& chosen) const
{
  double largest = 0.0;
  for (const std::size_t i : chosen)
  {
    largest = std::max(largest, Difference(this->coarse[i], this->pixels[i].color));
  }
  return largest;
}

std::vector<std::size_t> ChosenByChance(std::size_t count, std::uint64_t seed)
{
  constexpr std::size_t Part = 24;
  std::mt19937_64 random(seed);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (random() % Part == 0)
    {
      chosen.push_back(i);
    }
  }
  return chosen;
}

// The number of pixels that may be beyond the tolerance.
std::size_t MostBeyond(std::size_t count)
{
  return count - 1 - count * 999 / 1000;
}

std::size_t CountOf(const Pixels& pixels, bool (Pixels::*is)(std::size_t) const)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.Count(); ++i)
  {
    count += (pixels.*is)(i);
  }
  return count;
}

// Refines the pixels with an error above a limit, the worst ones first, until it is certain that
// too many are beyond the tolerance.
void RefineWorst(Pixels& pixels, double limit)
{
  constexpr std::size_t AtOnce = 32;
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < pixels.Count(); ++i)
  {
    if (!(pixels[i].error <= limit) && !pixels[i].isRefined)
    {
      suspects.push_back(i);
    }
  }
  std::sort(suspects.begin(), suspects.end(),
    [&](std::size_t one, std::size_t other) { return pixels[one].error > pixels[other].error; });
  for (std::size_t first = 0; first < suspects.size(); first += AtOnce)
  {
    const std::size_t last = std::min(first + AtOnce, suspects.size());
    pixels.Refine(
      { suspects.begin() + std::ptrdiff_t(first), suspects.begin() + std::ptrdiff_t(last) });
    if (CountOf(pixels, &Pixels::IsBeyond) > MostBeyond(pixels.Count()))
    {
      return;
    }
  }
}

PictureVerdict VerdictOf(const Pixels& pixels, const JudgeScene& scene)
{
  const std::size_t most = MostBeyond(pixels.Count());
  const std::size_t beyond = CountOf(pixels, &Pixels::IsBeyond);
  const std::size_t doubtful = CountOf(pixels, &Pixels::IsDoubtful);
  using Answer = PictureVerdict::Answer;
  const Answer answer =
    beyond > most ? Answer::Beyond : (beyond + doubtful > most ? Answer::Unsettled : Answer::Kept);
  std::vector<std::size_t> order(pixels.Count());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t one, std::size_t other) { return pixels[one].error < pixels[other].error; });
  const double tolerance = scene.errorTolerance;
  const std::size_t worst = order.back();
  return { answer, pixels[order[pixels.Count() - 1 - most]].error / tolerance,
    pixels[worst].error / tolerance, int(beyond), int(doubtful), int(pixels.Count()),
    int(worst) % scene.width, int(worst) / scene.width };
}

}

PictureVerdict VerdictOn(const JudgeScene& scene, const std::vector<float>& drawn,
  const std::vector<float>& behind, std::uint64_t seed)
{
  constexpr double Suspect = 0.4; // an error that is looked at again [tolerances]
  constexpr double Trusted = 0.5; // the largest error of coarse pixels that are not
  Pixels pixels(scene, drawn, behind);
  pixels.JudgeAll();
  const std::vector<std::size_t> sample = ChosenByChance(pixels.Count(), seed);
  RefineWorst(pixels, Suspect * scene.errorTolerance);
  pixels.Refine(sample);
  const bool isCertain = CountOf(pixels, &Pixels::IsBeyond) > MostBeyond(pixels.Count());
  if (!isCertain && pixels.LargestChange(sample) > Trusted * scene.errorTolerance)
  {
    RefineWorst(pixels, 0.0);
  }
  return VerdictOf(pixels, scene);
}

}
