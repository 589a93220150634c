#include "Frame/VolumeGeometry.h"

#include "Frame/NumberCheck.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace varimarch
{

bool IsFinite(const glm::dmat4& matrix)
{
  const double* const numbers = glm::value_ptr(matrix);
  return std::all_of(numbers, numbers + 16, [](double number) { return std::isfinite(number); });
}

namespace
{

// Factors of a gradient in VTK's sense: differences over distances, times the mean spacing.
glm::dvec3 GradientFactors(glm::dvec3 spacing)
{
  const glm::dvec3 absolute = glm::abs(spacing);
  return (absolute.x + absolute.y + absolute.z) / 3.0 / (2.0 * absolute);
}

glm::dvec3 ColumnLengths(const glm::dmat4& matrix)
{
  const glm::dmat3 axes(matrix);
  return { glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) };
}

// True if floats can hold the axes of a matrix and their products, and these span a space.
bool HasThickness(const glm::dmat4& matrix)
{
  constexpr double Shortest = 1e-15;
  constexpr double Longest = 1e15;
  constexpr double LeastSine = 1e-9;
  const glm::dvec3 lengths = ColumnLengths(matrix);
  const double volume = lengths.x * lengths.y * lengths.z;
  return IsFinite(matrix) && std::min({ lengths.x, lengths.y, lengths.z }) >= Shortest &&
    std::max({ lengths.x, lengths.y, lengths.z }) <= Longest &&
    std::abs(glm::determinant(glm::dmat3(matrix))) > LeastSine * volume;
}

// The distances between voxels along the axes, as text.
std::string LengthsOf(const glm::dmat4& matrix)
{
  const glm::dvec3 lengths = ColumnLengths(matrix);
  return TextOf(lengths.x) + " x " + TextOf(lengths.y) + " x " + TextOf(lengths.z);
}

}

glm::dmat3 VolumeGeometry::WorldFromGridNormal() const
{
  return glm::transpose(glm::inverse(this->WorldFromGridDirection()));
}

double VolumeGeometry::SmallestSpacingMm() const
{
  const glm::dmat3 axes = this->WorldFromGridDirection();
  return this->smallestGap *
    std::min({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}

double VolumeGeometry::DiagonalMm() const
{
  const glm::dmat3 axes = this->WorldFromGridDirection();
  const glm::dvec3 extent = this->boxGrid.upper - this->boxGrid.lower;
  // The longest of the four diagonals: they differ when the volume is sheared.
  double longest = 0.0;
  for (double signY : { -1.0, 1.0 })
  {
    for (double signZ : { -1.0, 1.0 })
    {
      longest = std::max(longest, glm::length(axes * (extent * glm::dvec3(1.0, signY, signZ))));
    }
  }
  return longest;
}

double VolumeGeometry::ShortestSampleDistanceMm() const
{
  return this->DiagonalMm() / 20000.0;
}

VolumeGeometry VolumeGeometryOf(vtkImageData* image, vtkVolume* volume, VoxelPlace place)
{
  int extent[6];
  image->GetExtent(extent);
  vtkNew<vtkMatrix4x4> worldFromData;
  volume->GetMatrix(worldFromData);

  VolumeGeometry geometry;
  glm::dvec3 firstIndex;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = extent[2 * axis + 1] - extent[2 * axis] + 1;
    const bool isOfCells = place == VoxelPlace::Cells && points > 1;
    const bool isThin = !isOfCells && points == 1;
    const int voxels = isOfCells ? points - 1 : points;
    geometry.dimensions[axis] = voxels;
    geometry.boxGrid.lower[axis] = isOfCells || isThin ? -0.5 : 0.0;
    geometry.boxGrid.upper[axis] = isOfCells || isThin ? voxels - 0.5 : voxels - 1.0;
    firstIndex[axis] = extent[2 * axis] + (isOfCells ? 0.5 : 0.0);
  }
  geometry.dataFromGrid =
    FromVtk(image->GetIndexToPhysicalMatrix()) * glm::translate(glm::dmat4(1.0), firstIndex);
  geometry.worldFromGrid = FromVtk(worldFromData) * geometry.dataFromGrid;
  const double* const spacing = image->GetSpacing();
  geometry.gradientFactors = GradientFactors({ spacing[0], spacing[1], spacing[2] });
  return geometry;
}

VolumeGeometry VolumeGeometryOf(const std::vector<UnevenAxis>& axes, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> worldFromData;
  volume->GetMatrix(worldFromData);
  VolumeGeometry geometry;
  glm::dvec3 first(0.0);
  glm::dvec3 step(1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.dimensions[axis] = axes[axis].VoxelCount();
    geometry.boxGrid.lower[axis] = axes[axis].LowerGrid();
    geometry.boxGrid.upper[axis] = axes[axis].UpperGrid();
    geometry.smallestGap = std::min(geometry.smallestGap, axes[axis].SmallestGapGrid());
    first[axis] = axes[axis].FirstVoxel();
    step[axis] = axes[axis].Step();
  }
  geometry.dataFromGrid = glm::scale(glm::translate(glm::dmat4(1.0), first), step);
  geometry.worldFromGrid = FromVtk(worldFromData) * geometry.dataFromGrid;
  geometry.gradientFactors = GradientFactors(step);
  return geometry;
}

double ShadowReachMm(double part, const VolumeGeometry& geometry)
{
  constexpr double Exponent = 0.33; // as in VTK
  return part < 1.0 ? geometry.DiagonalMm() * (1.0 - std::pow(1.0 - part, Exponent))
                    : std::numeric_limits<double>::infinity();
}

double OcclusionReachMm(double chosenMm, const VolumeGeometry& geometry)
{
  constexpr double UsualVoxels = 16.0;
  return chosenMm > 0.0 ? chosenMm : UsualVoxels * geometry.SmallestSpacingMm();
}

void CheckPlaces(const VolumeGeometry& geometry)
{
  if (!HasThickness(geometry.dataFromGrid))
  {
    throw std::invalid_argument("Cannot draw a volume whose voxels lie " +
      LengthsOf(geometry.dataFromGrid) + " apart, from " +
      TextOf(glm::dvec3(geometry.dataFromGrid[3])) +
      " on: expected finite numbers other than 0; set the spacing, origin and direction of the "
      "image");
  }
  if (!HasThickness(geometry.worldFromGrid))
  {
    throw std::invalid_argument("Cannot draw a volume whose matrix makes its voxels lie " +
      LengthsOf(geometry.worldFromGrid) + " apart, from " +
      TextOf(glm::dvec3(geometry.worldFromGrid[3])) +
      " on: expected a matrix of finite numbers that has an inverse; set the position, "
      "orientation, "
      "scale and user matrix of the vtkVolume");
  }
}

void CheckView(vtkRenderer* renderer)
{
  const glm::dmat4 clipFromWorld = ClipFromWorld(renderer);
  if (!IsFinite(clipFromWorld) || !IsFinite(glm::inverse(clipFromWorld)))
  {
    glm::dvec3 eyeWorld;
    glm::dvec3 focusWorld;
    renderer->GetActiveCamera()->GetPosition(glm::value_ptr(eyeWorld));
    renderer->GetActiveCamera()->GetFocalPoint(glm::value_ptr(focusWorld));
    throw std::invalid_argument("Cannot draw the view of a camera at " + TextOf(eyeWorld) +
      " that looks at " + TextOf(focusWorld) +
      ": expected finite numbers that make a view; set its position, focal point, view up, angle, "
      "parallel scale and clipping range");
  }
}

glm::dmat4 GridFromGrid(const VolumeGeometry& to, const VolumeGeometry& from)
{
  return glm::inverse(to.worldFromGrid) * from.worldFromGrid;
}

Viewport ViewportOf(vtkRenderer* renderer)
{
  Viewport viewport;
  renderer->GetTiledSizeAndOrigin(
    &viewport.width, &viewport.height, &viewport.left, &viewport.bottom);
  return viewport;
}

glm::dmat4 FromVtk(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

glm::dmat4 ClipFromWorld(vtkRenderer* renderer)
{
  vtkMatrix4x4* viewFromWorld = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* clipFromView = nullptr;
  vtkMatrix4x4* clipFromWorld = nullptr;
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  camera->GetKeyMatrices(renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  // VTK transposes this matrix for OpenGL, so it has GLM's column order.
  return glm::make_mat4(clipFromWorld->GetData());
}

}
