#include "Scene/CurvedPicture.h"

#include "Scene/VoxelIndex.h"

#include <vtkImageData.h>

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace varimarch
{

namespace
{

// Rows begin on the side that `across` points to.
double OffsetMm(const CurvedRequest& request, double row)
{
  return request.mmPerPixel * (0.5 * request.height - row);
}

}

std::vector<std::uint8_t> CurvedPicture(
  vtkImageData* image, const CurvePath& path, const CurvedRequest& request)
{
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height);
  const SlabSampler sampler(image, request.look);
  const auto drawColumn = [&](int column)
  {
    const double distanceMm = request.mmPerPixel * (column + 0.5);
    if (distanceMm > path.LengthMm())
    {
      return;
    }
    const CurvePath::Place place = path.At(distanceMm, request.turnDegrees);
    const glm::dvec3 middle = VoxelIndexOf(place.pointMm, image);
    const auto step = [&](const glm::dvec3& stepMm)
    { return VoxelIndexOf(place.pointMm + stepMm, image) - middle; };
    const glm::dvec3 perMm = step(place.across);
    const glm::dvec3 through = step(sampler.StepMm() * glm::cross(place.along, place.across));
    for (int row = 0; row < request.height; ++row)
    {
      pixels[std::size_t(row) * request.width + column] =
        sampler.GrayAt(middle + OffsetMm(request, row + 0.5) * perMm, through);
    }
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, request.width),
    [&](const tbb::blocked_range<int>& columns)
    {
      for (int column = columns.begin(); column != columns.end(); ++column)
      {
        drawColumn(column);
      }
    });
  return pixels;
}

glm::dvec3 PointInCurved(
  const CurvePath& path, const CurvedRequest& request, double column, double row)
{
  const CurvePath::Place place = path.At(request.mmPerPixel * column, request.turnDegrees);
  return place.pointMm + OffsetMm(request, row) * place.across;
}

}
