#include "Judge.h"

#include <vtkVolumeMapper.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

// The largest or smallest value of a ray, at the ends and turns of each cell's polynomial.
glm::dvec4 Extreme(
  const JudgeVolume& volume, const JudgeRay& ray, std::array<double, 2> part, double sign)
{
  double best = -Infinite;
  volume.WalkAll(ray, part[0], part[1],
    [&](const JudgeSpan& span)
    {
      for (const double u : JudgeTurns(span.value))
      {
        best = std::max(best, sign * ValueOf(span.value, u));
      }
      return true;
    });
  if (best == -Infinite)
  {
    return glm::dvec4(0.0);
  }
  const double value = sign * best;
  const JudgeLook& look = volume.looks.front();
  const JudgeLook::Band& band = look[look.BandOf(value)];
  const double opacity = look.Opacity(band, value);
  return { opacity * look.Color(band, value), opacity };
}

// The integrals of a x and of 1 over the parts of a ray whose values are within a range.
class GraySum
{
public:
  GraySum(const JudgeScene& scene, const double (&range)[2], int fineness)
    : scene(scene)
    , look(scene.volumes.front().looks.front())
    , range{ range[0], range[1] }
    , parts(std::max(fineness, 1))
  {
  }

  void Add(const JudgeSpan& span);

  double gray = 0.0;
  double lengthMm = 0.0;

private:
  std::vector<double> CutsOf(const JudgeSpan& span) const;
  double MeanGray(const JudgeSpan& span, const JudgeLook::Band& band, double from, double to) const;

  const JudgeScene& scene;
  const JudgeLook& look;
  double range[2];
  int parts;
};

// The ends of the parts of a span within one band, and within the range or not.
std::vector<double> GraySum::CutsOf(const JudgeSpan& span) const
{
  const std::vector<double> turns = JudgeTurns(span.value);
  std::vector<double> cuts = turns;
  for (std::size_t i = 0; i + 1 < turns.size(); ++i)
  {
    const double ends[2] = { ValueOf(span.value, turns[i]), ValueOf(span.value, turns[i + 1]) };
    const auto [least, most] = std::minmax(ends[0], ends[1]);
    std::vector<double> values = { this->range[0], this->range[1] };
    for (int band = this->look.BandOf(least); band < this->look.BandOf(most); ++band)
    {
      values.push_back(this->look[band].upper);
    }
    for (const double value : values)
    {
      if (least < value && value < most)
      {
        cuts.push_back(JudgeCrossing(span.value, value, turns[i], turns[i + 1]));
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

double GraySum::MeanGray(
  const JudgeSpan& span, const JudgeLook::Band& band, double from, double to) const
{
  static const double Offset = 0.5 * std::sqrt(0.6); // Gauss' rule of three points
  const double first = this->scene.grayRange[0];
  const double width = this->scene.grayRange[1] - first;
  const double step = (to - from) / this->parts;
  double sum = 0.0;
  for (int i = 0; i < this->parts; ++i)
  {
    const auto at = [&](double offset)
    {
      const double value = ValueOf(span.value, from + (i + 0.5 + offset) * step);
      return width > 0.0 ? this->look.Opacity(band, value) * (value - first) / width : 0.0;
    };
    sum += (8.0 * at(0.0) + 5.0 * (at(-Offset) + at(Offset))) / 18.0;
  }
  return sum / this->parts;
}

void GraySum::Add(const JudgeSpan& span)
{
  const std::vector<double> cuts = this->CutsOf(span);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const double middle = ValueOf(span.value, 0.5 * (cuts[i] + cuts[i + 1]));
    if (cuts[i] < cuts[i + 1] && this->range[0] <= middle && middle <= this->range[1])
    {
      const JudgeLook::Band& band = this->look[this->look.BandOf(middle)];
      const double partMm = (cuts[i + 1] - cuts[i]) * (span.exit - span.enter);
      this->gray += partMm * this->MeanGray(span, band, cuts[i], cuts[i + 1]);
      this->lengthMm += partMm;
    }
  }
}

GraySum SumOf(const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part,
  const double (&range)[2], int fineness)
{
  GraySum sum(scene, range, fineness);
  scene.volumes.front().WalkAll(ray, part[0], part[1],
    [&](const JudgeSpan& span)
    {
      sum.Add(span);
      return true;
    });
  return sum;
}

glm::dvec4 Gray(double level)
{
  return glm::dvec4(glm::dvec3(level), 1.0);
}

// All surfaces that the ray passes, front to back.
glm::dvec4 Isosurfaces(const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part)
{
  const JudgeVolume& volume = scene.volumes.front();
  const JudgeLook& look = volume.looks.front();
  const JudgeLight light(scene, 1);
  glm::dvec3 color(0.0);
  double transmittance = 1.0;
  volume.WalkAll(ray, part[0], part[1],
    [&](const JudgeSpan& span)
    {
      const std::vector<double> turns = JudgeTurns(span.value);
      for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      {
        const double ends[2] = { ValueOf(span.value, turns[i]), ValueOf(span.value, turns[i + 1]) };
        std::vector<std::array<double, 2>> crossings;
        for (const double isovalue : scene.isovalues)
        {
          if (std::min(ends[0], ends[1]) < isovalue && isovalue <= std::max(ends[0], ends[1]))
          {
            crossings.push_back(
              { JudgeCrossing(span.value, isovalue, turns[i], turns[i + 1]), isovalue });
          }
        }
        std::sort(crossings.begin(), crossings.end());
        for (const auto& [u, isovalue] : crossings)
        {
          const JudgeLook::Band& band = look[look.BandOf(isovalue)];
          const double opacity = look.Opacity(band, isovalue);
          const JudgedLight lit = volume.isShaded
            ? light.At({ 0, &span, u, ray.At(span.PlaceOf(u)), -ray.direction })
            : JudgedLight{};
          color +=
            transmittance * opacity * (look.Color(band, isovalue) * lit.ofColor + lit.highlight);
          transmittance *= 1.0 - opacity;
        }
      }
      return transmittance > 1e-9;
    });
  return { color, 1.0 - transmittance };
}

}

glm::dvec4 JudgedProjection(
  const JudgeScene& scene, const JudgeRay& ray, std::array<double, 2> part, int fineness)
{
  const JudgeVolume& volume = scene.volumes.front();
  switch (scene.blendMode)
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return Extreme(volume, ray, part, 1.0);
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return Extreme(volume, ray, part, -1.0);
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return Isosurfaces(scene, ray, part);
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
    {
      const GraySum sum = SumOf(scene, ray, part, scene.averagedRange, fineness);
      return sum.lengthMm > 0.0 ? Gray(sum.gray / sum.lengthMm) : glm::dvec4(0.0);
    }
    default:
    {
      const GraySum sum = SumOf(scene, ray, part, { -Infinite, Infinite }, fineness);
      const double level = std::min(sum.gray / volume.unitDistanceMm, 1.0);
      return sum.lengthMm > 0.0 ? Gray(level) : glm::dvec4(0.0);
    }
  }
}

}
