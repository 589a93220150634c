#include "Scene/Pipeline/ScenePicking.h"

#include "Core/Look/TransferFunction.h"
#include "Scene/Looks/LookRegions.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"

#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Interpolated values of a volume.
class RayValues
{
public:
  explicit RayValues(vtkImageData* image, vtkImageData* mask = nullptr)
    : image(image)
    , mask(mask)
  {
    this->interpolator->SetInterpolationModeToLinear();
    this->interpolator->SetComponentCount(1); // volumes of colours have several
    this->interpolator->Initialize(image);
  }

  std::optional<double> At(const glm::dvec3& pointWorld)
  {
    const glm::dvec3 index = VoxelIndexOf(pointWorld, this->image);
    const int* const extent = this->image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(index[axis] >= extent[2 * axis] && index[axis] <= extent[2 * axis + 1]))
      {
        return std::nullopt;
      }
    }
    if (!Keeps(this->mask, this->image, index))
    {
      return std::nullopt;
    }
    return this->AtIndex(index);
  }

  /// Gradient magnitude at a point in the volume [units of the data per mm], by central differences
  /// over one voxel to each side.
  double GradientMagnitudeAt(const glm::dvec3& pointWorld)
  {
    const glm::dvec3 index = VoxelIndexOf(pointWorld, this->image);
    const double* const spacing = this->image->GetSpacing();
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 step(0.0);
      step[axis] = 1.0;
      gradient[axis] =
        (this->AtIndex(index + step) - this->AtIndex(index - step)) / (2.0 * spacing[axis]);
    }
    return glm::length(gradient);
  }

private:
  // Indices outside the volume are clamped to the outermost voxels.
  double AtIndex(glm::dvec3 index)
  {
    const int* const extent = this->image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = std::clamp(index[axis], double(extent[2 * axis]), double(extent[2 * axis + 1]));
    }
    double value;
    this->interpolator->InterpolateIJK(&index.x, &value);
    return value;
  }

  vtkImageData* image;
  vtkImageData* mask; ///< may be null
  vtkNew<vtkImageInterpolator> interpolator;
};

// Absorption along a ray from front to back, for composites and isosurfaces.
class RayLight
{
public:
  explicit RayLight(const Look& look)
    : look(look)
    , function(look.colors, look.opacities, look.opacityUnitDistanceMm)
  {
    if (!look.gradientOpacities.empty())
    {
      this->gradientOpacity.emplace(look.colors, look.gradientOpacities, 1.0);
    }
  }

  /// @param value  empty where a cut removed the volume
  bool IsHalfAbsorbedAfter(
    std::optional<double> value, RayValues& values, const glm::dvec3& pointWorld, double stepMm)
  {
    if (value && this->look.blend == Blend::Composite)
    {
      const double gradient = this->gradientOpacity || !this->look.regions.empty()
        ? values.GradientMagnitudeAt(pointWorld)
        : 0.0;
      this->opticalDepth += stepMm * this->Extinction(*value, gradient);
    }
    if (value && this->before && this->look.blend == Blend::Isosurface)
    {
      this->PassSurfaces(*this->before, *value);
    }
    this->before = value;
    return this->opticalDepth >= std::log(2.0);
  }

private:
  // Finds the opacity per unit distance before converting it to an extinction.
  double Extinction(double value, double gradient) const
  {
    if (!this->look.regions.empty())
    {
      return -std::log1p(-ColorInRegions(this->look.regions, value, gradient).a) /
        this->look.opacityUnitDistanceMm;
    }
    const double factor = this->gradientOpacity ? this->gradientOpacity->Opacity(gradient) : 1.0;
    return factor < 1.0
      ? -std::log1p(-factor * this->function.Opacity(value)) / this->look.opacityUnitDistanceMm
      : this->function.Extinction(value);
  }

  // Surfaces at the faces of the volume or at cuts do not count.
  void PassSurfaces(double from, double to)
  {
    for (const Isosurface& surface : this->look.isosurfaces)
    {
      const bool isPassed = (from >= surface.value) != (to >= surface.value);
      this->opticalDepth -= isPassed ? std::log1p(-surface.opacity) : 0.0;
    }
  }

  const Look& look;
  TransferFunction function;
  std::optional<TransferFunction>
    gradientOpacity; ///< opacity factor by gradient magnitude; empty: 1
  double opticalDepth = 0.0;
  std::optional<double> before;
};

}

std::optional<std::array<double, 3>> PointSeen(const Scene& scene, vtkImageData* image,
  const std::array<double, 3>& from, const std::array<double, 3>& to, vtkImageData* mask)
{
  const TransferFunction look(
    scene.look.colors, scene.look.opacities, scene.look.opacityUnitDistanceMm);
  const std::vector<CutPlane> planes = PlanesOf(scene.cuts, image);
  const double* const spacing = image->GetSpacing();
  const double stepMm = 0.25 * std::min({ spacing[0], spacing[1], spacing[2] });
  const glm::dvec3 start = VectorOf(from);
  const glm::dvec3 direction = glm::normalize(VectorOf(to) - start);
  const double lengthMm = glm::distance(start, VectorOf(to));

  RayValues values(image, mask);
  RayLight light(scene.look);
  double largestOpacity = 0.0;
  std::optional<std::array<double, 3>> seen;
  for (double t = 0.5 * stepMm; t < lengthMm; t += stepMm)
  {
    const glm::dvec3 point = start + t * direction;
    const std::optional<double> value =
      IsKept(point, planes) ? values.At(point) : std::optional<double>();
    if (light.IsHalfAbsorbedAfter(value, values, point, stepMm))
    {
      return NumbersOf(point);
    }
    if (value && IsProjection(scene.look.blend) && look.Opacity(*value) > largestOpacity)
    {
      largestOpacity = look.Opacity(*value);
      seen = NumbersOf(point);
    }
  }
  return seen;
}

bool IsHidden(const Scene& scene, vtkImageData* image, const std::array<double, 3>& eye,
  const std::array<double, 3>& point, vtkImageData* mask)
{
  const double* const spacing = image->GetSpacing();
  const double surfaceMm = 2.0 * std::max({ spacing[0], spacing[1], spacing[2] });
  const glm::dvec3 toEye = VectorOf(eye) - VectorOf(point);
  const double distanceMm = glm::length(toEye);
  return !IsProjection(scene.look.blend) && distanceMm > surfaceMm &&
    PointSeen(scene, image, eye, NumbersOf(VectorOf(point) + surfaceMm / distanceMm * toEye), mask);
}

std::optional<double> ValueAt(vtkImageData* image, const std::array<double, 3>& pointMm)
{
  return RayValues(image).At(VectorOf(pointMm));
}

}
