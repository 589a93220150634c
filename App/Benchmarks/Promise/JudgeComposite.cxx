#include "Judge.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double Nothing = 1e-6; // transmittance behind which nothing counts

// A part of a ray in which one volume is smooth.
struct Segment
{
  double enter;
  double exit;
  std::size_t span;
  const JudgeLook::Band* band;
};

// The segments of a volume along a ray, in order.
struct Segments
{
  const JudgeVolume* volume;
  std::vector<JudgeSpan> spans;
  std::vector<Segment> segments;
  std::size_t next = 0;
};

Segments SegmentsOf(const JudgeVolume& volume, const JudgeRay& ray, std::array<double, 2> part)
{
  Segments found{ &volume, {}, {} };
  std::vector<JudgePiece> pieces;
  volume.WalkVisible(ray, part[0], part[1],
    [&](const JudgeSpan& span)
    {
      found.spans.push_back(span);
      volume.FindPieces(span, pieces);
      for (const JudgePiece& piece : pieces)
      {
        found.segments.push_back(
          { span.PlaceOf(piece.from), span.PlaceOf(piece.to), found.spans.size() - 1, piece.band });
      }
      return true;
    });
  return found;
}

// Gauss' collocation of three stages: places, weights, and the weights of the way to each place.
struct GaussRule
{
  double root = std::sqrt(15.0);
  double places[3] = { 0.5 - this->root / 10.0, 0.5, 0.5 + this->root / 10.0 };
  double weights[3] = { 5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0 };
  double before[3][3] = { { 5.0 / 36.0, 2.0 / 9.0 - this->root / 15.0,
                            5.0 / 36.0 - this->root / 30.0 },
    { 5.0 / 36.0 + this->root / 24.0, 2.0 / 9.0, 5.0 / 36.0 - this->root / 24.0 },
    { 5.0 / 36.0 + this->root / 30.0, 2.0 / 9.0 + this->root / 15.0, 5.0 / 36.0 } };
};

const GaussRule Gauss;

class CompositeSum
{
public:
  CompositeSum(const JudgeScene& scene, const JudgeRay& ray, int fineness)
    : scene(scene)
    , ray(ray)
    , light(scene, std::max(fineness, 1))
    , fineness(fineness)
  {
    this->isLit = scene.occlusion > 0.0 ||
      std::any_of(scene.volumes.begin(), scene.volumes.end(),
        [](const JudgeVolume& volume) { return volume.isShaded; });
  }

  void Add(std::vector<Segments>& all, double enter, double exit);
  glm::dvec4 Color() const { return { this->color, 1.0 - this->transmittance }; }
  bool IsFinished() const { return this->transmittance < Nothing; }

private:
  struct Active
  {
    int volume;
    const JudgeVolume* of;
    const JudgeSpan* span;
    const JudgeLook::Band* band;
    double ExtinctionAt(double t) const
    {
      return this->of->ExtinctionAt(*this->span, *this->band, this->span->PartOf(t));
    }
  };

  void AddPart(double enter, double exit, int halvings);
  void AddStraight(const double (&extinctions)[3], double enter, double exit);
  JudgedLight LightAt(const Active& one, double t) const;
  double ExtinctionAt(double t) const;

  const JudgeScene& scene;
  const JudgeRay& ray;
  JudgeLight light;
  int fineness;
  bool isLit;
  std::vector<Active> active;
  glm::dvec3 color = glm::dvec3(0.0);
  double transmittance = 1.0;
};

void CompositeSum::Add(std::vector<Segments>& all, double enter, double exit)
{
  const double middle = 0.5 * (enter + exit);
  this->active.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    Segments& of = all[i];
    while (of.next < of.segments.size() && of.segments[of.next].exit <= middle)
    {
      ++of.next;
    }
    if (of.next < of.segments.size() && of.segments[of.next].enter < middle)
    {
      const Segment& segment = of.segments[of.next];
      this->active.push_back({ int(i), of.volume, &of.spans[segment.span], segment.band });
    }
  }
  const int parts = std::max(this->fineness, 1);
  const double width = (exit - enter) / parts;
  for (int i = 0; i < parts && !this->active.empty() && !this->IsFinished(); ++i)
  {
    this->AddPart(enter + i * width, enter + (i + 1) * width, 0);
  }
}

double CompositeSum::ExtinctionAt(double t) const
{
  double sum = 0.0;
  for (const Active& one : this->active)
  {
    sum += one.ExtinctionAt(t);
  }
  return sum;
}

// Halves dense parts, the front half first, until each absorbs little.
void CompositeSum::AddPart(double enter, double exit, int halvings)
{
  constexpr double MostDepth = 0.5;
  constexpr int MostHalvings = 40;
  double extinctions[3];
  double mean = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    extinctions[i] = this->ExtinctionAt(enter + Gauss.places[i] * (exit - enter));
    mean += Gauss.weights[i] * extinctions[i];
  }
  if (mean * (exit - enter) > MostDepth && halvings < MostHalvings)
  {
    const double middle = 0.5 * (enter + exit);
    this->AddPart(enter, middle, halvings + 1);
    if (!this->IsFinished())
    {
      this->AddPart(middle, exit, halvings + 1);
    }
    return;
  }
  if (mean > 0.0)
  {
    this->AddStraight(extinctions, enter, exit);
  }
}

JudgedLight CompositeSum::LightAt(const Active& one, double t) const
{
  return this->light.At(
    { one.volume, one.span, one.span->PartOf(t), this->ray.At(t), -this->ray.direction });
}

void CompositeSum::AddStraight(const double (&extinctions)[3], double enter, double exit)
{
  const double width = exit - enter;
  for (const Active& one : this->active)
  {
    JudgedLight light;
    if (this->isLit && this->fineness == Judge::Coarse)
    {
      light = this->LightAt(one, 0.5 * (enter + exit));
    }
    for (int i = 0; i < 3; ++i)
    {
      const double t = enter + Gauss.places[i] * width;
      const double extinction = one.ExtinctionAt(t);
      double before = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        before += width * Gauss.before[i][k] * extinctions[k];
      }
      const double weight =
        this->transmittance * std::exp(-before) * Gauss.weights[i] * width * extinction;
      if (weight < 1e-8)
      {
        continue;
      }
      if (this->isLit && this->fineness != Judge::Coarse)
      {
        light = this->LightAt(one, t);
      }
      const double u = one.span->PartOf(t);
      const glm::dvec3 rgb =
        one.of->looks[std::size_t(one.span->look)].Color(*one.band, ValueOf(one.span->value, u));
      this->color += weight * (rgb * light.ofColor + light.highlight);
    }
  }
  double depth = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    depth += width * Gauss.weights[i] * extinctions[i];
  }
  this->transmittance *= std::exp(-depth);
}

}

glm::dvec4 JudgedComposite(
  const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part, int fineness)
{
  std::vector<Segments> all;
  std::vector<double> ends;
  for (const JudgeVolume& volume : scene.volumes)
  {
    all.push_back(SegmentsOf(volume, ray, part));
    for (const Segment& segment : all.back().segments)
    {
      ends.push_back(segment.enter);
      ends.push_back(segment.exit);
    }
  }
  std::sort(ends.begin(), ends.end());
  CompositeSum sum(scene, ray, fineness);
  for (std::size_t i = 0; i + 1 < ends.size() && !sum.IsFinished(); ++i)
  {
    if (ends[i] < ends[i + 1])
    {
      sum.Add(all, ends[i], ends[i + 1]);
    }
  }
  return sum.Color();
}

}
