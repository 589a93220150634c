#include "Readers/NiftiGeometry.h"

#include "Readers/SpmMatrix.h"
#include "Readers/VolumeFile.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace varimarch
{
namespace
{

double MmPerUnit(int units)
{
  constexpr int metre = 1;
  constexpr int micrometre = 3;
  const int lengthUnit = units & 7;
  return lengthUnit == metre ? 1000.0 : lengthUnit == micrometre ? 0.001 : 1.0;
}

/// Geometry in RAS from the affine form, the header's "method 3".
ImageGeometry AffineGeometry(const NiftiHeader& header)
{
  ImageGeometry geometry;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.axesMm[axis][row] = header.affine[row][axis];
    }
    geometry.originMm[row] = header.affine[row][3];
  }
  return geometry;
}

/// Size of a voxel along an axis. The standard wants it positive; like nibabel, this takes 0 for 1.
double VoxelSize(const NiftiHeader& header, int axis)
{
  const double size = std::abs(header.pixdim[axis + 1]);
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
}

/// Geometry in RAS from the quaternion form, the header's "method 2".
ImageGeometry QuaternionGeometry(const NiftiHeader& header)
{
  const double b = header.quaternion[0];
  const double c = header.quaternion[1];
  const double d = header.quaternion[2];
  const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
  ImageGeometry geometry;
  geometry.axesMm = glm::mat3_cast(glm::normalize(glm::dquat(a, b, c, d)));
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] *= VoxelSize(header, axis);
  }
  geometry.axesMm[2] *= header.pixdim[0] < 0 ? -1.0 : 1.0;
  geometry.originMm = { header.quaternionOffset[0], header.quaternionOffset[1],
    header.quaternionOffset[2] };
  return geometry;
}

/// True if the numbers are finite and the axes span space.
bool IsValid(const ImageGeometry& geometry)
{
  const double volume = std::abs(glm::determinant(geometry.axesMm));
  const glm::dvec3 origin = geometry.originMm;
  return std::isnormal(volume) && std::isfinite(origin.x + origin.y + origin.z);
}

/// Replaces the step of an axis with a single voxel, which has no neighbours, if it is 0.
ImageGeometry WithAllAxes(const NiftiHeader& header, ImageGeometry geometry)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3& step = geometry.axesMm[axis];
    const bool isSingle = header.dim[0] <= axis || header.dim[axis + 1] == 1;
    if (isSingle && step == glm::dvec3(0.0))
    {
      const glm::dvec3 normal =
        glm::cross(geometry.axesMm[(axis + 1) % 3], geometry.axesMm[(axis + 2) % 3]);
      step = normal == glm::dvec3(0.0) ? normal : glm::normalize(normal) * VoxelSize(header, axis);
    }
  }
  return geometry;
}

/// The side that each axis faces most: 1, 2 or 3 for x, y or z, negative for the opposite.
std::array<int, 3> Sides(const ImageGeometry& geometry)
{
  std::array<int, 3> sides = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 size = glm::abs(geometry.axesMm[axis]);
    const int most = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    sides[std::size_t(axis)] = geometry.axesMm[axis][most] < 0.0 ? -most - 1 : most + 1;
  }
  return sides;
}

/// Geometry in RAS from the header's forms; nothing if it has no valid one.
std::optional<ImageGeometry> GeometryOfForms(
  const NiftiHeader& header, std::vector<std::string>& warnings)
{
  const ImageGeometry affine = WithAllAxes(header, AffineGeometry(header));
  const ImageGeometry quaternion = QuaternionGeometry(header);
  const bool hasAffine = header.affineCode > 0 && IsValid(affine);
  const bool hasQuaternion = header.quaternionCode > 0 && IsValid(quaternion);
  if (header.affineCode > 0 && !hasAffine)
  {
    warnings.push_back(std::string("The header's sform is not a valid matrix; ") +
      (hasQuaternion ? "the qform was used." : "only the size of a voxel was used."));
  }
  if (hasAffine && hasQuaternion && Sides(affine) != Sides(quaternion))
  {
    warnings.push_back("The header's sform and qform turn the volume to different sides. The sform "
                       "was used; other programs may show the volume mirrored.");
  }
  return hasAffine  ? std::optional(affine)
    : hasQuaternion ? std::optional(quaternion)
                    : std::nullopt;
}

/// Geometry in RAS from SPM's origin, which counts voxels from 1. In Analyze files of SPM the first
/// axis points to the patient's left.
std::optional<ImageGeometry> GeometryOfSpmOrigin(const NiftiHeader& header)
{
  const double* const origin = header.spmOrigin;
  bool isStated = origin[0] != 0.0 || origin[1] != 0.0 || origin[2] != 0.0;
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Like nibabel, this takes an origin far outside for other data.
    const double voxelCount = double(header.dim[axis + 1]);
    isStated = isStated && origin[axis] > -voxelCount && origin[axis] < 2.0 * voxelCount;
    geometry.axesMm[axis][axis] = VoxelSize(header, axis) * (axis == 0 ? -1.0 : 1.0);
    geometry.originMm[axis] = -geometry.axesMm[axis][axis] * (origin[axis] - 1.0);
  }
  return isStated ? std::optional(geometry) : std::nullopt;
}

}

ImageGeometry GeometryOf(
  const std::string& path, const NiftiHeader& header, std::vector<std::string>& warnings)
{
  std::optional<ImageGeometry> geometry = header.kind == NiftiKind::Analyze
    ? SpmMatrixBeside(path, warnings)
    : GeometryOfForms(header, warnings);
  if (!geometry && header.kind == NiftiKind::Analyze)
  {
    geometry = GeometryOfSpmOrigin(header);
  }
  const int usedAxes = int(std::min<std::int64_t>(3, header.dim[0]));
  if (std::any_of(header.pixdim + 1, header.pixdim + 1 + usedAxes,
        [](double size) { return !(std::abs(size) > 0.0); }))
  {
    warnings.push_back("The header does not say how large a voxel is along each axis; 1 mm was "
                       "assumed where it is missing.");
  }
  if (geometry)
  {
    return InLps(*geometry, LpsFromRas, MmPerUnit(header.units));
  }
  ImageGeometry sizes;
  for (int axis = 0; axis < 3; ++axis)
  {
    sizes.axesMm[axis][axis] = VoxelSize(header, axis);
  }
  warnings.push_back(UnknownSides);
  return InLps(sizes, glm::dvec3(1.0), MmPerUnit(header.units));
}

}
