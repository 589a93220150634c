#include "Scene/Model/SceneCuts.h"

#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/WorldVector.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageStencilToImage.h>
#include <vtkLassoStencilSource.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x3.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace varimarch
{

namespace
{

// Normal of a face: perpendicular to the two other axes. In a sheared volume it differs from the
// axis.
glm::dvec3 NormalOf(int axis, vtkImageData* image)
{
  const auto direction = [&](int of)
  {
    const double* const elements = image->GetDirectionMatrix()->GetData();
    return glm::dvec3(elements[of], elements[3 + of], elements[6 + of]);
  };
  const glm::dvec3 normal = glm::cross(direction((axis + 1) % 3), direction((axis + 2) % 3));
  return glm::dot(normal, direction(axis)) > 0.0 ? normal : -normal;
}

}

glm::dvec3 PointAtParts(const glm::dvec3& parts, vtkImageData* image)
{
  const int* const extent = image->GetExtent();
  double index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = extent[2 * axis];
    index[axis] = first + parts[axis] * (extent[2 * axis + 1] - first);
  }
  glm::dvec3 pointWorld;
  image->TransformContinuousIndexToPhysicalPoint(index, &pointWorld.x);
  return pointWorld;
}

std::vector<CutPlane> PlanesOf(const SceneCuts& cuts, vtkImageData* image)
{
  std::vector<CutPlane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 normal = NormalOf(axis, image);
    glm::dvec3 parts(0.5);
    if (parts[axis] = cuts.box[2 * axis]; parts[axis] > 0.0)
    {
      planes.push_back({ NumbersOf(PointAtParts(parts, image)), NumbersOf(normal) });
    }
    if (parts[axis] = cuts.box[2 * axis + 1]; parts[axis] < 1.0)
    {
      planes.push_back({ NumbersOf(PointAtParts(parts, image)), NumbersOf(-normal) });
    }
  }
  planes.insert(planes.end(), cuts.planes.begin(), cuts.planes.end());
  return planes;
}

bool IsKept(const glm::dvec3& pointMm, const std::vector<CutPlane>& planes)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const CutPlane& plane)
    { return glm::dot(VectorOf(plane.normal), pointMm - VectorOf(plane.pointMm)) >= 0.0; });
}

std::array<double, 3> MiddleOf(vtkImageData* image)
{
  return NumbersOf(PointAtParts(glm::dvec3(0.5), image));
}

void MoveFace(std::array<double, 6>& box, int face, double part)
{
  constexpr double Thinnest = 0.001;
  box[face] = face % 2 == 0 ? std::clamp(part, 0.0, box[face + 1] - Thinnest)
                            : std::clamp(part, box[face - 1] + Thinnest, 1.0);
}

std::array<double, 6> BoxInOther(
  const std::array<double, 6>& box, vtkImageData* image, vtkImageData* other)
{
  const std::array<double, 6> whole = SceneCuts().box;
  std::array<double, 6> moved = whole;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    glm::dvec3 parts(0.5);
    parts[axis] = box[face];
    const glm::dvec3 pointWorld = PointAtParts(parts, image);
    double index[3];
    other->TransformPhysicalPointToContinuousIndex(&pointWorld.x, index);
    const int* const extent = other->GetExtent() + 2 * axis;
    const double steps = std::max(1, extent[1] - extent[0]);
    if (box[face] != whole[face])
    {
      MoveFace(moved, face, (index[axis] - extent[0]) / steps);
    }
  }
  return moved;
}

std::array<double, 2> ReachAlong(const std::array<double, 3>& normal, vtkImageData* image)
{
  const glm::dvec3 direction = glm::normalize(VectorOf(normal));
  const glm::dvec3 middle = PointAtParts(glm::dvec3(0.5), image);
  std::array<double, 2> reach = { std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 parts(corner & 1, corner >> 1 & 1, corner >> 2);
    const double distanceMm = glm::dot(direction, PointAtParts(parts, image) - middle);
    reach = { std::min(reach[0], distanceMm), std::max(reach[1], distanceMm) };
  }
  return reach;
}

double DepthOf(const CutPlane& plane, vtkImageData* image)
{
  const auto [first, last] = ReachAlong(plane.normal, image);
  const glm::dvec3 fromMiddle = VectorOf(plane.pointMm) - VectorOf(MiddleOf(image));
  const double distanceMm = glm::dot(glm::normalize(VectorOf(plane.normal)), fromMiddle);
  return std::clamp((distanceMm - first) / (last - first), 0.0, 1.0);
}

CutPlane AtDepth(double depth, const CutPlane& plane, vtkImageData* image)
{
  const auto [first, last] = ReachAlong(plane.normal, image);
  const glm::dvec3 alongMm =
    (first + depth * (last - first)) * glm::normalize(VectorOf(plane.normal));
  return { NumbersOf(VectorOf(MiddleOf(image)) + alongMm), plane.normal };
}

namespace
{

constexpr int StencilPixels = 2048; // side of the stencil; finer than a screen
constexpr std::int64_t MostMaskVoxels = std::int64_t(1) << 24;

// Projects world space to the image coordinates of ScissorsCut::outline.
glm::dmat4x3 OutlineFromWorld(const Camera& camera)
{
  vtkNew<vtkCamera> placed;
  const double anyBounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  PlaceCamera(camera, anyBounds, 1.0, placed);
  vtkMatrix4x4* const view = placed->GetViewTransformMatrix();
  const double half = camera.parallel ? placed->GetParallelScale()
                                      : std::tan(0.5 * glm::radians(camera.viewAngleDegrees));
  glm::dmat4x3 matrix;
  for (int column = 0; column < 4; ++column)
  {
    const double divisor =
      camera.parallel ? (column == 3 ? 1.0 : 0.0) : -view->GetElement(2, column);
    matrix[column] = { view->GetElement(0, column) / half, view->GetElement(1, column) / half,
      divisor };
  }
  return matrix;
}

vtkSmartPointer<vtkImageData> FilledOutline(const std::vector<std::array<double, 2>>& outline)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 2>& point : outline)
  {
    points->InsertNextPoint(point[0], point[1], 0.0);
  }
  const double* const bounds = points->GetBounds();
  const double longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], 1e-9 });
  const double spacing = longest / StencilPixels;
  vtkNew<vtkLassoStencilSource> lasso;
  lasso->SetPoints(points);
  lasso->SetOutputOrigin(bounds[0], bounds[2], 0.0);
  lasso->SetOutputSpacing(spacing, spacing, 1.0);
  lasso->SetOutputWholeExtent(0, int(std::ceil((bounds[1] - bounds[0]) / spacing)), 0,
    int(std::ceil((bounds[3] - bounds[2]) / spacing)), 0, 0);
  vtkNew<vtkImageStencilToImage> filled;
  filled->SetInputConnection(lasso->GetOutputPort());
  filled->SetOutputScalarTypeToUnsignedChar();
  filled->Update();
  return filled->GetOutput();
}

// The part of space that a cut removes: the outline extruded to a cone or a prism.
class Stencil
{
public:
  explicit Stencil(const ScissorsCut& cut)
    : outlineFromWorld(varimarch::OutlineFromWorld(cut.camera))
    , keepsInside(cut.keepsInside)
    , inside(FilledOutline(cut.outline))
  {
  }

  /// Homogeneous image coordinates: divide the first two by the third.
  glm::dvec3 Projected(const glm::dvec3& pointWorld) const
  {
    return this->outlineFromWorld * glm::dvec4(pointWorld, 1.0);
  }

  bool Removes(const glm::dvec3& projected) const
  {
    return this->HasInside(projected) != this->keepsInside;
  }

private:
  bool HasInside(const glm::dvec3& projected) const
  {
    // Points behind the eye are not in the image.
    if (projected.z <= 0.0)
    {
      return false;
    }
    const double* const origin = this->inside->GetOrigin();
    const double perUnit = 1.0 / this->inside->GetSpacing()[0];
    const double column = (projected.x / projected.z - origin[0]) * perUnit + 0.5;
    const double row = (projected.y / projected.z - origin[1]) * perUnit + 0.5;
    const int* const size = this->inside->GetDimensions();
    if (!(column >= 0.0 && column < size[0] && row >= 0.0 && row < size[1]))
    {
      return false;
    }
    const auto* const pixels = static_cast<const unsigned char*>(this->inside->GetScalarPointer());
    return pixels[std::size_t(row) * size[0] + std::size_t(column)] != 0;
  }

  glm::dmat4x3 outlineFromWorld;
  bool keepsInside;
  vtkSmartPointer<vtkImageData> inside; ///< rasterized outline: 1 inside, 0 outside
};

// Takes what another mask of the same box removes from a new mask.
void KeepOnly(vtkImageData* kept, vtkImageData* mask)
{
  const int* const size = mask->GetDimensions();
  const int* const keptSize = kept->GetDimensions();
  const auto* const keptVoxels = static_cast<const unsigned char*>(kept->GetScalarPointer());
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  const auto nearest = [&](int voxel, int axis)
  { return std::int64_t((voxel + 0.5) * keptSize[axis] / size[axis]); };
  tbb::parallel_for(0, size[2],
    [&](int z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        const unsigned char* const row =
          keptVoxels + (nearest(z, 2) * keptSize[1] + nearest(y, 1)) * keptSize[0];
        for (int x = 0; x < size[0]; ++x)
        {
          voxels[(std::int64_t(z) * size[1] + y) * size[0] + x] = row[nearest(x, 0)];
        }
      }
    });
}

// Number of mask voxels along each axis.
std::array<int, 3> MaskSize(vtkImageData* image)
{
  const int* const size = image->GetDimensions();
  for (int factor = 1;; ++factor)
  {
    const auto along = [&](int axis) { return (size[axis] + factor - 1) / factor; };
    if (std::int64_t(along(0)) * along(1) * along(2) <= MostMaskVoxels)
    {
      return { along(0), along(1), along(2) };
    }
  }
}

// Centre of a mask voxel in world space. A mask voxel covers whole voxels of the volume.
glm::dvec3 MiddleOfMaskVoxel(
  const glm::dvec3& voxel, const std::array<int, 3>& maskSize, vtkImageData* image)
{
  const int* const extent = image->GetExtent();
  const int* const size = image->GetDimensions();
  double index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = extent[2 * axis] + (voxel[axis] + 0.5) * size[axis] / maskSize[axis] - 0.5;
  }
  glm::dvec3 world;
  image->TransformContinuousIndexToPhysicalPoint(index, &world.x);
  return world;
}

void RemoveFromMask(const Stencil& stencil, vtkImageData* mask, vtkImageData* image)
{
  const int* const dimensions = mask->GetDimensions();
  const std::array<int, 3> size = { dimensions[0], dimensions[1], dimensions[2] };
  const auto projected = [&](const glm::dvec3& voxel)
  { return stencil.Projected(MiddleOfMaskVoxel(voxel, size, image)); };
  const glm::dvec3 first = projected({ 0.0, 0.0, 0.0 });
  const glm::dvec3 alongX = projected({ 1.0, 0.0, 0.0 }) - first;
  const glm::dvec3 alongY = projected({ 0.0, 1.0, 0.0 }) - first;
  const glm::dvec3 alongZ = projected({ 0.0, 0.0, 1.0 }) - first;
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  tbb::parallel_for(tbb::blocked_range<int>(0, size[2]),
    [&](const tbb::blocked_range<int>& slices)
    {
      for (int z = slices.begin(); z != slices.end(); ++z)
      {
        unsigned char* voxel = voxels + std::int64_t(z) * size[0] * size[1];
        for (int y = 0; y < size[1]; ++y)
        {
          for (int x = 0; x < size[0]; ++x, ++voxel)
          {
            *voxel &= !stencil.Removes(
              first + double(x) * alongX + double(y) * alongY + double(z) * alongZ);
          }
        }
      }
    });
}

}

vtkSmartPointer<vtkImageData> MaskOf(
  const std::vector<ScissorsCut>& cuts, vtkImageData* image, vtkImageData* body)
{
  if (cuts.empty() && !body)
  {
    return nullptr;
  }
  const std::array<int, 3> size = MaskSize(image);
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(size.data());
  mask->SetDirectionMatrix(image->GetDirectionMatrix());
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  std::fill_n(voxels, mask->GetNumberOfPoints(), 1);
  if (body)
  {
    KeepOnly(body, mask);
  }
  for (const ScissorsCut& cut : cuts)
  {
    RemoveFromMask(Stencil(cut), mask, image);
  }
  return mask;
}

bool Keeps(vtkImageData* mask, vtkImageData* image, const glm::dvec3& index)
{
  if (!mask)
  {
    return true;
  }
  const int* const extent = image->GetExtent();
  const int* const size = image->GetDimensions();
  const int* const maskSize = mask->GetDimensions();
  int voxel[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double part = (index[axis] - extent[2 * axis] + 0.5) / size[axis];
    voxel[axis] = std::clamp(int(part * maskSize[axis]), 0, maskSize[axis] - 1);
  }
  return *static_cast<unsigned char*>(mask->GetScalarPointer(voxel)) != 0;
}

vtkSmartPointer<vtkImageData> Both(vtkImageData* fine, vtkImageData* other, vtkImageData* image)
{
  if (!fine || !other)
  {
    return fine ? fine : other;
  }
  auto both = vtkSmartPointer<vtkImageData>::New();
  both->DeepCopy(fine);
  const glm::dvec3 size = glm::dvec3(glm::ivec3(glm::make_vec3(image->GetDimensions())));
  const glm::ivec3 count = glm::make_vec3(fine->GetDimensions());
  const int* const extent = image->GetExtent();
  const glm::dvec3 first(extent[0], extent[2], extent[4]);
  auto* voxel = static_cast<unsigned char*>(both->GetScalarPointer());
  for (int z = 0; z < count.z; ++z)
  {
    for (int y = 0; y < count.y; ++y)
    {
      for (int x = 0; x < count.x; ++x, ++voxel)
      {
        // The middle of a voxel of the mask as an index of the image.
        const glm::dvec3 part = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(count);
        *voxel &= Keeps(other, image, first + part * size - 0.5);
      }
    }
  }
  return both;
}

vtkSmartPointer<vtkImageData> WithoutRemoved(vtkImageData* image, vtkImageData* mask)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(image);
  vtkDataArray* const scalars = copy->GetPointData()->GetScalars();
  std::vector<double> smallest;
  for (int component = 0; component < scalars->GetNumberOfComponents(); ++component)
  {
    smallest.push_back(scalars->GetRange(component)[0]);
  }
  const glm::ivec3 count = glm::make_vec3(image->GetDimensions());
  const int* const extent = image->GetExtent();
  const glm::dvec3 first(extent[0], extent[2], extent[4]);
  tbb::parallel_for(0, count.z,
    [&](int z)
    {
      vtkIdType voxel = vtkIdType(z) * count.x * count.y;
      for (int y = 0; y < count.y; ++y)
      {
        for (int x = 0; x < count.x; ++x, ++voxel)
        {
          if (!Keeps(mask, image, first + glm::dvec3(x, y, z)))
          {
            scalars->SetTuple(voxel, smallest.data());
          }
        }
      }
    });
  return copy;
}

bool operator==(const ScissorsCut& a, const ScissorsCut& b)
{
  return a.outline == b.outline && a.keepsInside == b.keepsInside &&
    a.camera.parallel == b.camera.parallel &&
    a.camera.viewAngleDegrees == b.camera.viewAngleDegrees && a.camera.pose == b.camera.pose;
}

}
