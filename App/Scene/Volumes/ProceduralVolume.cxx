#include "Scene/Volumes/ProceduralVolume.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <variant>
#include <vector>

namespace varimarch
{

namespace
{

/// A torso as CT shows it, in Hounsfield units: skin, fat, muscle, lungs with vessels, a heart and
/// an aorta full of contrast medium, liver, spine, ribs and breastbone. It is made of simple
/// solids, each painted over those before it, with edges as soft as a scanner's. It has no noise.
///
/// Positions are in mm, LPS, the origin in the middle of the chest.
class TorsoPhantom
{
public:
  struct Ellipsoid
  {
    glm::dvec3 center;
    glm::dvec3 radii;
  };

  /// An upright cylinder; the radii are those along x and y and half the height.
  struct EllipticCylinder
  {
    glm::dvec3 center;
    glm::dvec3 radii;
  };

  /// A line segment whose radius changes linearly from one end to the other.
  struct Capsule
  {
    glm::dvec3 start;
    glm::dvec3 end;
    double startRadius;
    double endRadius;
  };

  using Shape = std::variant<Ellipsoid, EllipticCylinder, Capsule>;

  struct Solid
  {
    Shape shape;
    double hounsfield;
    glm::dvec3 lower; ///< box that holds the shape and its soft edge
    glm::dvec3 upper;
  };

  /// Size of the box to sample [mm]: left-right, front-back, down-up. The body is cut off at the
  /// top and the bottom.
  static glm::dvec3 ExtentMm() { return { 380.0, 260.0, 320.0 }; }

  /// @param edgeWidthMm  width of the transition between two tissues, > 0: about a voxel
  /// @param seed         of the random lung vessels
  TorsoPhantom(double edgeWidthMm, unsigned seed);

  /// Hounsfield units at `count` positions that start at `firstMm` and continue along +x.
  std::vector<double> Row(glm::dvec3 firstMm, double stepMm, int count) const;

private:
  void Paint(double hounsfield, const Shape& shape);
  void PaintTube(double hounsfield, const std::vector<glm::dvec3>& path, double radius);
  void PaintBody();
  void PaintLungVessels(double side, unsigned seed);
  void PaintAirways();
  void PaintHeartAndVessels();
  void PaintSpine();
  void PaintRibs(double side);

  std::vector<Solid> solids;
  double edgeWidthMm;
};

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

// Vessels of a lung. Each branch ends in two thinner ones, until it is too thin or leaves the
// lung.
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
  // Unlike std::uniform_real_distribution, this gives the same numbers with every standard
  // library.
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

vtkSmartPointer<vtkImageData> EmptyVolume(
  const std::array<int, 3>& dimensions, const glm::dvec3& extentMm, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions[axis] < 2 || dimensions[axis] > LargestProceduralSide)
    {
      throw std::invalid_argument("a procedural volume needs 2 to " +
        std::to_string(LargestProceduralSide) + " voxels along each axis, not " +
        std::to_string(dimensions[axis]));
    }
  }
  image->SetSpacing(extentMm.x / (dimensions[0] - 1), extentMm.y / (dimensions[1] - 1),
    extentMm.z / (dimensions[2] - 1));
  image->SetOrigin(-0.5 * extentMm.x, -0.5 * extentMm.y, -0.5 * extentMm.z);
  image->AllocateScalars(type, 1);
  return image;
}

glm::dvec3 PositionMm(vtkImageData* image, int i, int j, int k)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  return { origin[0] + i * spacing[0], origin[1] + j * spacing[1], origin[2] + k * spacing[2] };
}

// Calls paintRow(row of voxels, j, k) for every row, in parallel.
template <class Scalar, class PaintRow>
void ForEachRow(vtkImageData* image, const PaintRow& paintRow)
{
  const int* dimensions = image->GetDimensions();
  auto* voxels = static_cast<Scalar*>(image->GetScalarPointer());
  tbb::parallel_for(0, dimensions[2],
    [&](int k)
    {
      for (int j = 0; j < dimensions[1]; ++j)
      {
        paintRow(voxels + (std::size_t(k) * dimensions[1] + j) * dimensions[0], j, k);
      }
    });
}

constexpr double CubeMm = 100.0;

vtkSmartPointer<vtkImageData> Shells(const ProceduralSource& source)
{
  auto image = EmptyVolume(source.dimensions, glm::dvec3(CubeMm), VTK_UNSIGNED_CHAR);
  const double* spacing = image->GetSpacing();
  const double halfEdgeMm = 0.75 * std::max({ spacing[0], spacing[1], spacing[2] });
  ForEachRow<std::uint8_t>(image,
    [&](std::uint8_t* row, int j, int k)
    {
      for (int i = 0; i < source.dimensions[0]; ++i)
      {
        // Shells of 5 mm at every 9 mm from the centre; the outer ones are fainter.
        const double radiusMm = glm::length(PositionMm(image, i, j, k));
        const double shell = std::min(std::floor(radiusMm / 9.0), 5.0);
        const double fromMiddleMm = std::abs(radiusMm - 9.0 * shell - 4.5);
        const double cover =
          1.0 - glm::smoothstep(2.5 - halfEdgeMm, 2.5 + halfEdgeMm, fromMiddleMm);
        row[i] = std::uint8_t(shell < 5.0 ? std::lround(cover * (240.0 - 50.0 * shell)) : 0);
      }
    });
  return image;
}

vtkSmartPointer<vtkImageData> MarschnerLobb(const ProceduralSource& source)
{
  constexpr double Frequency = 6.0;
  constexpr double Alpha = 0.25;
  constexpr double Pi = glm::pi<double>();
  auto image = EmptyVolume(source.dimensions, glm::dvec3(CubeMm), VTK_FLOAT);
  ForEachRow<float>(image,
    [&](float* row, int j, int k)
    {
      for (int i = 0; i < source.dimensions[0]; ++i)
      {
        const glm::dvec3 p = PositionMm(image, i, j, k) / (0.5 * CubeMm);
        const double radius = std::hypot(p.x, p.y);
        const double ripple = std::cos(2.0 * Pi * Frequency * std::cos(0.5 * Pi * radius));
        const double value = 1.0 - std::sin(0.5 * Pi * p.z) + Alpha * (1.0 + ripple);
        row[i] = float(value / (2.0 * (1.0 + Alpha)));
      }
    });
  return image;
}

vtkSmartPointer<vtkImageData> Checkerboard(const ProceduralSource& source)
{
  auto image = EmptyVolume(source.dimensions, glm::dvec3(CubeMm), VTK_UNSIGNED_CHAR);
  ForEachRow<std::uint8_t>(image,
    [&](std::uint8_t* row, int j, int k)
    {
      for (int i = 0; i < source.dimensions[0]; ++i)
      {
        row[i] = (i + j + k) % 2 == 0 ? 0 : 255;
      }
    });
  return image;
}

vtkSmartPointer<vtkImageData> Ramp(const ProceduralSource& source)
{
  auto image = EmptyVolume(source.dimensions, glm::dvec3(CubeMm), VTK_FLOAT);
  ForEachRow<float>(image,
    [&](float* row, int, int)
    {
      for (int i = 0; i < source.dimensions[0]; ++i)
      {
        row[i] = float(255.0 * i / (source.dimensions[0] - 1));
      }
    });
  return image;
}

// A normally distributed number of variance 1. It depends only on its arguments, so that the order
// of the threads does not matter. It is the sum of twelve uniform numbers (Irwin-Hall) from
// Steele's SplitMix64.
double Noise(std::uint64_t seed, std::uint64_t index)
{
  std::uint64_t state = (seed << 40) + 3 * index;
  double sum = 0.0;
  for (int draw = 0; draw < 3; ++draw)
  {
    std::uint64_t bits = ++state * 0x9E3779B97F4A7C15ull;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ull;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBull;
    bits ^= bits >> 31;
    for (int part = 0; part < 4; ++part)
    {
      sum += double((bits >> (16 * part)) & 0xFFFF) / 65535.0;
    }
  }
  return sum - 6.0;
}

vtkSmartPointer<vtkImageData> Torso(const ProceduralSource& source)
{
  constexpr double NoiseHounsfield = 12.0; // standard deviation, typical of abdominal protocols
  constexpr double Lowest = -1024.0;       // the lower end of the scanners' range
  auto image = EmptyVolume(source.dimensions, TorsoPhantom::ExtentMm(), VTK_SHORT);
  const double* spacing = image->GetSpacing();
  const double edgeMm = 1.5 * std::max({ spacing[0], spacing[1], spacing[2] });
  const TorsoPhantom phantom(edgeMm, source.seed);
  ForEachRow<std::int16_t>(image,
    [&](std::int16_t* row, int j, int k)
    {
      const std::vector<double> clean =
        phantom.Row(PositionMm(image, 0, j, k), spacing[0], source.dimensions[0]);
      const std::uint64_t first =
        (std::uint64_t(k) * source.dimensions[1] + j) * source.dimensions[0];
      for (int i = 0; i < source.dimensions[0]; ++i)
      {
        const double noisy = clean[i] + NoiseHounsfield * Noise(source.seed, first + i);
        row[i] = std::int16_t(std::lround(std::max(noisy, Lowest)));
      }
    });
  return image;
}

}

vtkSmartPointer<vtkImageData> ProceduralVolume(const ProceduralSource& source)
{
  switch (source.kind)
  {
    case ProceduralKind::Shells:
      return Shells(source);
    case ProceduralKind::MarschnerLobb:
      return MarschnerLobb(source);
    case ProceduralKind::Checkerboard:
      return Checkerboard(source);
    case ProceduralKind::Ramp:
      return Ramp(source);
    default:
      return Torso(source);
  }
}

}
