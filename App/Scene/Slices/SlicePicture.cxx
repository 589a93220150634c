#include "Scene/Slices/SlicePicture.h"

#include "Scene/Model/WorldVector.h"

#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkMatrix3x3.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The part of the range of a PET scan that its slices and the preset pet-maximum show.
constexpr double PetPartShown = 0.5;

bool IsPet(const LoadedVolume& volume)
{
  return volume.modality == "PT";
}

}

std::array<double, 2> AutomaticWindow(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  // Organs that excrete the tracer are many times brighter than the body.
  const bool isPet = IsPet(volume);
  const double first = isPet ? 0.0 : statistics.Percentile(0.1);
  const double last = (isPet ? PetPartShown : 1.0) * statistics.Percentile(99.9);
  return { std::max(last - first, 1e-6), 0.5 * (first + last) };
}

SliceGrays SuggestedGrays(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  return { volume.windowLevel ? *volume.windowLevel : AutomaticWindow(volume, statistics),
    IsPet(volume) || volume.isInverted };
}

std::vector<std::uint8_t> SlicePicture(vtkImageData* image, const SliceRequest& request)
{
  std::vector<std::uint8_t> pixels(std::size_t(request.width) * request.height);
  const SliceGrid grid(image, request);
  const SlabSampler sampler(
    image, { request.window, request.level, request.slabMm, request.slabBlend, request.inverted });
  const glm::dvec3 through = grid.Through(sampler.StepMm());
  tbb::parallel_for(tbb::blocked_range<int>(0, request.height),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        for (int column = 0; column < request.width; ++column)
        {
          pixels[std::size_t(row) * request.width + column] =
            sampler.GrayAt(grid.IndexAt(column, row), through);
        }
      }
    });
  return pixels;
}

SliceGrid::SliceGrid(vtkImageData* image, const SliceRequest& request)
  : extent(image->GetExtent())
{
  const SliceAxes axes = AxesOf(request.plane, request.turn);
  const glm::dvec3 middle = VectorOf(request.middleMm);
  const glm::dvec3 middleIndex = VoxelIndexOf(middle, image);
  const auto step = [&](const glm::dvec3& directionMm)
  { return VoxelIndexOf(middle + directionMm, image) - middleIndex; };
  this->right = step(request.mmPerPixel * VectorOf(axes.right));
  this->down = step(request.mmPerPixel * VectorOf(axes.down));
  this->throughPerMm = step(VectorOf(axes.through));
  this->first = middleIndex + (0.5 - 0.5 * request.width) * this->right +
    (0.5 - 0.5 * request.height) * this->down;
}

glm::dvec3 SliceGrid::IndexAt(int column, int row) const
{
  return this->first + double(column) * this->right + double(row) * this->down;
}

bool IsWithin(const glm::dvec3& index, const int* extent)
{
  constexpr double Rounding = 1e-6; // a turned plane must not miss the one slice of an image
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(index[axis] >= extent[2 * axis] - Rounding &&
          index[axis] <= extent[2 * axis + 1] + Rounding))
    {
      return false;
    }
  }
  return true;
}

SlabSampler::SlabSampler(vtkImageData* image, const SlabLook& look)
  : look(look)
  , extent(image->GetExtent())
{
  const double* const spacing = image->GetSpacing();
  this->stepMm = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  // Farther from the middle of the slab than the volume is long there are no samples.
  const double halfMm = std::min(0.5 * look.slabMm, image->GetLength());
  this->steps = int(std::ceil(halfMm / this->stepMm));
  this->interpolator->SetInterpolationModeToLinear();
  this->interpolator->SetComponentCount(1); // volumes of colours have several
  this->interpolator->Initialize(image);
}

SlabSampler::~SlabSampler() = default;

std::uint8_t SlabSampler::GrayAt(const glm::dvec3& index, const glm::dvec3& through) const
{
  const std::optional<double> value = this->BlendedThrough(index, through);
  if (!value || std::isnan(*value))
  {
    return 0;
  }
  const double part = (*value - this->look.level) / this->look.window + 0.5;
  const double gray = std::clamp(part, 0.0, 1.0);
  return std::uint8_t(std::lround(255.0 * (this->look.inverted ? 1.0 - gray : gray)));
}

std::optional<double> SlabSampler::BlendedThrough(
  const glm::dvec3& index, const glm::dvec3& through) const
{
  std::optional<double> blended;
  int count = 0;
  for (int step = -this->steps; step <= this->steps; ++step)
  {
    if (const auto value = this->ValueAt(index + double(step) * through))
    {
      blended = blended ? this->Blended(*blended, *value) : *value;
      ++count;
    }
  }
  return blended && this->look.slabBlend == SlabBlend::Mean ? *blended / count : blended;
}

double SlabSampler::Blended(double a, double b) const
{
  switch (this->look.slabBlend)
  {
    case SlabBlend::Minimum:
      return std::min(a, b);
    case SlabBlend::Mean:
      return a + b;
    default:
      return std::max(a, b);
  }
}

std::optional<double> SlabSampler::ValueAt(const glm::dvec3& index) const
{
  if (!IsWithin(index, this->extent))
  {
    return std::nullopt;
  }
  double value;
  this->interpolator->InterpolateIJK(&index.x, &value);
  return value;
}

namespace
{

// The cosine between an axis of the image and the normal of a plane.
double CosineOf(vtkImageData* image, SlicePlane plane, int axis)
{
  const std::array<double, 3> through = AxesOf(plane).through;
  double cosine = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    cosine += image->GetDirectionMatrix()->GetElement(i, axis) * through[i];
  }
  return std::abs(cosine);
}

int NearestAxis(vtkImageData* image, SlicePlane plane)
{
  int nearest = 0;
  for (const int axis : { 1, 2 })
  {
    nearest = CosineOf(image, plane, axis) > CosineOf(image, plane, nearest) ? axis : nearest;
  }
  return nearest;
}

}

std::optional<SliceNumber> SliceNumberAt(
  vtkImageData* image, SlicePlane plane, const std::array<double, 3>& pointMm)
{
  constexpr double SmallestCosine = 0.9999; // 0.8 degrees
  const int axis = NearestAxis(image, plane);
  if (CosineOf(image, plane, axis) < SmallestCosine)
  {
    return std::nullopt;
  }
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(pointMm.data(), index);
  const int first = image->GetExtent()[2 * axis];
  const int count = image->GetDimensions()[axis];
  return SliceNumber{ 1 + int(std::lround(std::clamp(index[axis] - first, 0.0, count - 1.0))),
    count };
}

double SliceStepMm(vtkImageData* image, SlicePlane plane)
{
  return image->GetSpacing()[NearestAxis(image, plane)];
}

namespace
{

// The only axis along which a volume has one voxel; empty if there is none, or more.
std::optional<int> AxisOfOneVoxel(vtkImageData* volume)
{
  const int* const count = volume->GetDimensions();
  return std::count(count, count + 3, 1) == 1
    ? std::optional(int(std::find(count, count + 3, 1) - count))
    : std::nullopt;
}

// The shortest rotation of a direction onto the line of another one.
SliceTurn TurnOnto(const glm::dvec3& from, const glm::dvec3& line)
{
  constexpr double SmallestSine = 1e-9;
  const glm::dvec3 to = glm::dot(from, line) < 0.0 ? -line : line;
  const glm::dvec3 axis = glm::cross(from, to);
  const double sine = glm::length(axis);
  return sine < SmallestSine
    ? SliceTurn()
    : TurnedBy({}, NumbersOf(axis / sine), glm::degrees(std::atan2(sine, glm::dot(from, to))));
}

}

std::optional<SingleImage> SingleImageOf(vtkImageData* volume)
{
  const std::optional<int> axis = AxisOfOneVoxel(volume);
  if (!axis)
  {
    return std::nullopt;
  }
  vtkMatrix3x3* const direction = volume->GetDirectionMatrix();
  const glm::dvec3 normal = glm::normalize(glm::dvec3(direction->GetElement(0, *axis),
    direction->GetElement(1, *axis), direction->GetElement(2, *axis)));
  const auto throughOf = [](SlicePlane plane) { return VectorOf(AxesOf(plane).through); };
  const SlicePlane planes[] = { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal };
  const SlicePlane nearest = *std::max_element(std::begin(planes), std::end(planes),
    [&](SlicePlane a, SlicePlane b) {
      return std::abs(glm::dot(throughOf(a), normal)) < std::abs(glm::dot(throughOf(b), normal));
    });
  return SingleImage{ nearest, TurnOnto(throughOf(nearest), normal) };
}

SliceTurn FirstTurnOf(vtkImageData* volume)
{
  const std::optional<SingleImage> single = SingleImageOf(volume);
  return single ? single->turn : SliceTurn();
}

}
