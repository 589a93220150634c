#include "Scene/TorsoPhantom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace varimarch
{

namespace
{

// Rounded Hounsfield units from textbooks; vessels as in the arterial phase.
constexpr double Air = -1000.0;
constexpr double LungTissue = -850.0;
constexpr double Fat = -100.0;
constexpr double SpinalFluid = 20.0;
constexpr double Skin = 40.0;
constexpr double Muscle = 55.0;
constexpr double Disc = 90.0;
constexpr double Liver = 110.0;
constexpr double HeartMuscle = 110.0;
constexpr double Cartilage = 120.0;
constexpr double SpongyBone = 230.0;
constexpr double VenousBlood = 260.0;
constexpr double ArterialBlood = 340.0;
constexpr double DenseBone = 650.0;

constexpr double Left = 1.0;
constexpr double Right = -1.0;

// Signed distances to a surface, negative inside. They are exact near the surface, which is all
// that the soft edges need.

double EllipsoidDistance(glm::dvec3 offset, glm::dvec3 radii)
{
  const double scaled = glm::length(offset / radii);
  const double slope = glm::length(offset / (radii * radii));
  return slope > 0.0 ? scaled * (scaled - 1.0) / slope : -std::min({ radii.x, radii.y, radii.z });
}

double DistanceMm(const TorsoPhantom::Ellipsoid& ellipsoid, glm::dvec3 position)
{
  return EllipsoidDistance(position - ellipsoid.center, ellipsoid.radii);
}

double DistanceMm(const TorsoPhantom::EllipticCylinder& cylinder, glm::dvec3 position)
{
  const glm::dvec3 offset = position - cylinder.center;
  const double around =
    EllipsoidDistance({ offset.x, offset.y, 0.0 }, { cylinder.radii.x, cylinder.radii.y, 1.0 });
  return std::max(around, std::abs(offset.z) - cylinder.radii.z);
}

double DistanceMm(const TorsoPhantom::Capsule& capsule, glm::dvec3 position)
{
  const glm::dvec3 axis = capsule.end - capsule.start;
  const double along = glm::clamp(
    glm::dot(position - capsule.start, axis) / glm::max(glm::dot(axis, axis), 1e-12), 0.0, 1.0);
  return glm::length(position - capsule.start - along * axis) -
    glm::mix(capsule.startRadius, capsule.endRadius, along);
}

std::pair<glm::dvec3, glm::dvec3> Bounds(const TorsoPhantom::Ellipsoid& ellipsoid)
{
  return { ellipsoid.center - ellipsoid.radii, ellipsoid.center + ellipsoid.radii };
}

std::pair<glm::dvec3, glm::dvec3> Bounds(const TorsoPhantom::EllipticCylinder& cylinder)
{
  return { cylinder.center - cylinder.radii, cylinder.center + cylinder.radii };
}

std::pair<glm::dvec3, glm::dvec3> Bounds(const TorsoPhantom::Capsule& capsule)
{
  const glm::dvec3 radius(std::max(capsule.startRadius, capsule.endRadius));
  return { glm::min(capsule.start, capsule.end) - radius,
    glm::max(capsule.start, capsule.end) + radius };
}

TorsoPhantom::Ellipsoid Lung(double side)
{
  return { { side * 74.0, 4.0, 15.0 }, { 58.0, 78.0, 128.0 } };
}

// Vessels of a lung. Each branch ends in two thinner ones, until it is too thin or leaves the lung.
class VesselTree
{
public:
  VesselTree(const TorsoPhantom::Ellipsoid& lung, unsigned seed)
    : lung({ lung.center, lung.radii - 6.0 })
    , random(seed)
  {
  }

  void Grow(glm::dvec3 start, glm::dvec3 direction, double radius)
  {
    constexpr double ThinnestMm = 0.7;
    const glm::dvec3 end = start + direction * (5.0 + 4.5 * radius);
    if (radius < ThinnestMm || DistanceMm(this->lung, end) > 0.0)
    {
      return;
    }
    const double endRadius = 0.85 * radius;
    this->branches.push_back({ start, end, radius, endRadius });
    const glm::dvec3 aside = 0.65 * this->RandomVector();
    this->Grow(end, glm::normalize(direction + aside), 0.95 * endRadius);
    this->Grow(end, glm::normalize(direction - aside), 0.85 * endRadius);
  }

  const std::vector<TorsoPhantom::Capsule>& Branches() const { return this->branches; }

private:
  // Unlike std::uniform_real_distribution, this gives the same numbers with every standard library.
  double RandomNumber() { return this->random() / 4294967296.0; }

  glm::dvec3 RandomVector()
  {
    const double z = 2.0 * this->RandomNumber() - 1.0;
    const double angle = glm::radians(360.0) * this->RandomNumber();
    const double around = std::sqrt(1.0 - z * z);
    return { around * std::cos(angle), around * std::sin(angle), z };
  }

  TorsoPhantom::Ellipsoid lung;
  std::mt19937 random;
  std::vector<TorsoPhantom::Capsule> branches;
};

}

TorsoPhantom::TorsoPhantom(double edgeWidthMm, unsigned seed)
  : edgeWidthMm(edgeWidthMm)
{
  this->PaintBody();
  this->PaintLungVessels(Left, seed);
  this->PaintLungVessels(Right, seed + 1);
  this->PaintAirways();
  this->PaintHeartAndVessels();
  this->PaintSpine();
  this->PaintRibs(Left);
  this->PaintRibs(Right);
}

std::vector<double> TorsoPhantom::Row(glm::dvec3 firstMm, double stepMm, int count) const
{
  std::vector<double> row(count, Air);
  for (const Solid& solid : this->solids)
  {
    if (firstMm.y < solid.lower.y || firstMm.y > solid.upper.y || firstMm.z < solid.lower.z ||
      firstMm.z > solid.upper.z)
    {
      continue;
    }
    const int first = int(std::max(0.0, std::ceil((solid.lower.x - firstMm.x) / stepMm)));
    const int last = int(std::min(count - 1.0, std::floor((solid.upper.x - firstMm.x) / stepMm)));
    for (int i = first; i <= last; ++i)
    {
      const glm::dvec3 position(firstMm.x + i * stepMm, firstMm.y, firstMm.z);
      const double distance =
        std::visit([&](const auto& shape) { return DistanceMm(shape, position); }, solid.shape);
      const double half = 0.5 * this->edgeWidthMm;
      row[i] = glm::mix(row[i], solid.hounsfield, 1.0 - glm::smoothstep(-half, half, distance));
    }
  }
  return row;
}

void TorsoPhantom::Paint(double hounsfield, const Shape& shape)
{
  const auto [lower, upper] = std::visit([](const auto& s) { return Bounds(s); }, shape);
  const glm::dvec3 edge(0.5 * this->edgeWidthMm);
  this->solids.push_back({ shape, hounsfield, lower - edge, upper + edge });
}

void TorsoPhantom::PaintTube(double hounsfield, const std::vector<glm::dvec3>& path, double radius)
{
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    this->Paint(hounsfield, Capsule{ path[i - 1], path[i], radius, radius });
  }
}

void TorsoPhantom::PaintBody()
{
  const double tall = ExtentMm().z; // extends beyond the box at the top and the bottom
  this->Paint(Skin, EllipticCylinder{ {}, { 172.0, 112.0, tall } });
  this->Paint(Fat, EllipticCylinder{ {}, { 169.5, 109.5, tall } });
  this->Paint(Muscle, EllipticCylinder{ {}, { 158.0, 97.0, tall } });
  this->Paint(Fat, Ellipsoid{ { 0.0, -25.0, 50.0 }, { 28.0, 40.0, 90.0 } });
  this->Paint(LungTissue, Lung(Left));
  this->Paint(LungTissue, Lung(Right));
}

void TorsoPhantom::PaintLungVessels(double side, unsigned seed)
{
  VesselTree tree(Lung(side), seed);
  const glm::dvec3 hilum(side * 44.0, 4.0, 35.0);
  for (const glm::dvec3 direction : { glm::dvec3(side * 0.6, -0.3, 1.0),
         glm::dvec3(side * 1.0, -0.6, 0.0), glm::dvec3(side * 0.6, 0.4, -1.0) })
  {
    tree.Grow(hilum, glm::normalize(direction), 5.0);
  }
  for (const Capsule& branch : tree.Branches())
  {
    this->Paint(ArterialBlood, branch);
  }
}

void TorsoPhantom::PaintAirways()
{
  // Walls first, then the air inside them.
  for (const auto& [hounsfield, thicker] : { std::pair(Muscle, 1.5), std::pair(Air, 0.0) })
  {
    const glm::dvec3 carina(0.0, 14.0, 60.0);
    this->PaintTube(hounsfield, { { 0.0, 8.0, 200.0 }, carina }, 8.5 + thicker);
    this->PaintTube(hounsfield, { carina, { 46.0, 16.0, 30.0 } }, 5.5 + thicker);
    this->PaintTube(hounsfield, { carina, { -42.0, 16.0, 36.0 } }, 6.0 + thicker);
  }
  this->Paint(Liver, Ellipsoid{ { -58.0, 0.0, -135.0 }, { 88.0, 76.0, 60.0 } });
  this->Paint(Liver, Ellipsoid{ { 78.0, 15.0, -145.0 }, { 58.0, 58.0, 48.0 } });
}

void TorsoPhantom::PaintHeartAndVessels()
{
  this->Paint(HeartMuscle, Ellipsoid{ { 26.0, -38.0, -28.0 }, { 54.0, 42.0, 56.0 } });
  this->Paint(ArterialBlood, Ellipsoid{ { 42.0, -36.0, -34.0 }, { 26.0, 24.0, 38.0 } });
  this->Paint(VenousBlood, Ellipsoid{ { 4.0, -52.0, -32.0 }, { 18.0, 17.0, 34.0 } });
  this->Paint(ArterialBlood, Ellipsoid{ { 20.0, -8.0, 4.0 }, { 27.0, 15.0, 18.0 } });

  const glm::dvec3 trunk(14.0, -24.0, 45.0); // pulmonary trunk
  this->PaintTube(VenousBlood, { { -24.0, -22.0, 200.0 }, { -24.0, -24.0, -5.0 } }, 9.0);
  this->PaintTube(ArterialBlood, { { 10.0, -54.0, -5.0 }, trunk }, 13.0);
  this->PaintTube(ArterialBlood, { trunk, { -46.0, 2.0, 37.0 } }, 8.0);
  this->PaintTube(ArterialBlood, { trunk, { 46.0, 4.0, 38.0 } }, 8.0);

  // The aorta: up from the heart, over the arch, down along the spine.
  this->PaintTube(ArterialBlood,
    { { 22.0, -34.0, 0.0 }, { 2.0, -38.0, 58.0 }, { 5.0, -26.0, 80.0 }, { 14.0, -6.0, 90.0 },
      { 24.0, 16.0, 82.0 }, { 28.0, 28.0, 60.0 }, { 26.0, 34.0, -60.0 }, { 12.0, 26.0, -200.0 } },
    12.0);
  this->PaintTube(ArterialBlood, { { 6.0, -22.0, 86.0 }, { -26.0, -12.0, 200.0 } }, 5.0);
  this->PaintTube(ArterialBlood, { { 14.0, -6.0, 95.0 }, { 20.0, -8.0, 200.0 } }, 4.0);
  this->PaintTube(ArterialBlood, { { 22.0, 10.0, 90.0 }, { 60.0, 6.0, 200.0 } }, 4.5);
}

void TorsoPhantom::PaintSpine()
{
  constexpr double PeriodMm = 28.0;
  for (int i = -6; i <= 6; ++i)
  {
    const double z = PeriodMm * i;
    this->Paint(Disc, EllipticCylinder{ { 0.0, 48.0, z + 14.0 }, { 17.0, 14.0, 4.0 } });
    this->Paint(DenseBone, EllipticCylinder{ { 0.0, 48.0, z }, { 18.5, 15.5, 11.0 } });
    this->Paint(SpongyBone, EllipticCylinder{ { 0.0, 48.0, z }, { 16.0, 13.0, 8.5 } });
    this->Paint(DenseBone, EllipticCylinder{ { 0.0, 71.0, z }, { 13.0, 11.5, 8.0 } });
    this->Paint(DenseBone, Capsule{ { 0.0, 82.0, z }, { 0.0, 92.0, z - 14.0 }, 4.0, 3.0 });
    for (const double side : { Left, Right })
    {
      this->Paint(
        DenseBone, Capsule{ { side * 12.0, 66.0, z }, { side * 34.0, 74.0, z + 4.0 }, 5.0, 3.5 });
    }
  }
  this->Paint(SpinalFluid, EllipticCylinder{ { 0.0, 71.0, 0.0 }, { 9.0, 8.0, ExtentMm().z } });
}

void TorsoPhantom::PaintRibs(double side)
{
  const EllipticCylinder breastbone = { { 0.0, -84.0, 40.0 }, { 18.0, 5.0, 70.0 } };
  for (int i = -4; i <= 7; ++i)
  {
    // The path runs from the spine around the chest and descends by 60 mm.
    const double z = 28.0 * i;
    std::vector<glm::dvec3> path = { { side * 20.0, 56.0, z } };
    for (double degrees = 18.0; degrees <= 150.0; degrees += 11.0)
    {
      const double angle = glm::radians(degrees);
      path.push_back({ side * 147.0 * std::sin(angle), 85.0 * std::cos(angle),
        z + 8.0 - 60.0 * degrees / 150.0 });
    }
    this->PaintTube(DenseBone, path, 5.5);
    this->PaintTube(SpongyBone, path, 3.0);
    const double endZ = path.back().z + 12.0;
    if (std::abs(endZ - breastbone.center.z) < breastbone.radii.z)
    {
      this->PaintTube(Cartilage, { path.back(), { side * 16.0, -84.0, endZ } }, 5.0);
    }
  }
  this->Paint(DenseBone, breastbone);
  this->Paint(SpongyBone, EllipticCylinder{ breastbone.center, breastbone.radii - 2.5 });
}

}
