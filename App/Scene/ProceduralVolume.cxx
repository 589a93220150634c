#include "Scene/ProceduralVolume.h"

#include "Scene/TorsoPhantom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace varimarch
{

namespace
{

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
