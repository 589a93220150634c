#include "LightVolumeMethod.h"

#include "SliceMethod.h"
#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace varimarch
{

namespace
{

// Distances between neighbouring voxels along each axis [mm].
glm::dvec3 SpacingsMm(const VolumeGeometry& geometry)
{
  const glm::dmat3 worldFromGrid = geometry.WorldFromGridDirection();
  return { glm::length(worldFromGrid[0]), glm::length(worldFromGrid[1]),
    glm::length(worldFromGrid[2]) };
}

// Points that are as far apart along each axis as the voxels allow.
glm::ivec3 PointsFor(const VolumeGeometry& geometry, int mostPoints)
{
  const glm::dvec3 cells = glm::max(geometry.dimensions - 1, glm::ivec3(1));
  const glm::dvec3 lengths = cells * SpacingsMm(geometry);
  const double longest = std::max({ lengths.x, lengths.y, lengths.z });
  const glm::dvec3 points = glm::ceil(double(mostPoints - 1) * lengths / longest) + 1.0;
  return glm::max(glm::ivec3(glm::min(points, cells + 1.0)), glm::ivec3(2));
}

// Optical depth between a point and a distant light, by samples in the middles of steps.
double OpticalDepth(const ComparisonVolume& volume, const Ray& toLightGrid, double stepMm)
{
  const ScalarGrid<float> texels = volume.Texels();
  const Interval inside = Intersection(toLightGrid, volume.Geometry().boxGrid);
  double depth = 0.0;
  for (double t = inside.enter; t < inside.exit; t += stepMm)
  {
    const double lengthMm = std::min(stepMm, inside.exit - t);
    const glm::dvec3 middle = toLightGrid.origin + (t + 0.5 * lengthMm) * toLightGrid.direction;
    depth += volume.Extinction(texels.Value(middle)) * lengthMm;
  }
  return depth;
}

std::vector<float> LightAt(
  const ComparisonVolume& volume, glm::ivec3 points, const glm::dvec3& toLightWorld)
{
  const VolumeGeometry& geometry = volume.Geometry();
  const glm::dvec3 directionGrid = glm::inverse(geometry.WorldFromGridDirection()) * toLightWorld;
  const glm::dvec3 spacings = SpacingsMm(geometry);
  const double stepMm = std::min({ spacings.x, spacings.y, spacings.z });
  const Box& box = geometry.boxGrid;
  std::vector<float> light(std::size_t(points.x) * points.y * points.z);
  tbb::parallel_for(0, points.y * points.z,
    [&](int row)
    {
      for (int x = 0; x < points.x; ++x)
      {
        const glm::dvec3 part =
          glm::dvec3(x, row % points.y, row / points.y) / glm::dvec3(points - 1);
        const Ray ray = { glm::mix(box.lower, box.upper, part), directionGrid };
        light[std::size_t(row) * points.x + x] =
          float(std::exp(-OpticalDepth(volume, ray, stepMm)));
      }
    });
  return light;
}

}

void LightVolumeMethod::Draw(const ComparisonFrame& frame, int mostPoints, bool fromBehind)
{
  this->Update(frame, mostPoints);
  DrawLitSlices(frame, this->light, fromBehind);
}

void LightVolumeMethod::Update(const ComparisonFrame& frame, int mostPoints)
{
  const glm::dvec3& toLightWorld = frame.toLightWorld;
  if (this->builtVersion == frame.volume.Version() && this->builtFor == toLightWorld &&
    this->builtMostPoints == mostPoints)
  {
    return;
  }
  vtkOpenGLRenderWindow* const window = frame.view.window;
  const glm::ivec3 points = PointsFor(frame.volume.Geometry(), mostPoints);
  std::vector<float> texels = LightAt(frame.volume, points, toLightWorld);
  this->Release(window);
  this->light->SetContext(window);
  this->light->SetInternalFormat(GL_R32F);
  this->light->SetFormat(GL_RED);
  this->light->SetDataType(GL_FLOAT);
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (!this->light->Create3DFromRaw(
        unsigned(points.x), unsigned(points.y), unsigned(points.z), 1, VTK_FLOAT, texels.data()))
  {
    throw std::runtime_error("A comparison method found no memory for a texture of light");
  }
  FilterLinearly(this->light);
  this->builtVersion = frame.volume.Version();
  this->builtFor = toLightWorld;
  this->builtMostPoints = mostPoints;
}

std::size_t LightVolumeMethod::Bytes() const
{
  return this->builtVersion < 0
    ? 0
    : sizeof(float) * this->light->GetWidth() * this->light->GetHeight() * this->light->GetDepth();
}

void LightVolumeMethod::Release(vtkWindow* window)
{
  this->light->ReleaseGraphicsResources(window);
  this->builtVersion = -1;
}

}
