#ifndef Varimarch_Scene_SlicePicture_h
#define Varimarch_Scene_SlicePicture_h

#include "Scene/Model/Scene.h"
#include "Scene/Slices/SliceAxes.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkNew.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class vtkImageData;
class vtkImageInterpolator;

namespace varimarch
{

/// A slice to draw.
struct SliceRequest
{
  SlicePlane plane;
  std::array<double, 3> middleMm; ///< centre of the image in world space
  double mmPerPixel;              ///< > 0
  int width;                      ///< pixels
  int height;
  double window; ///< width of the value range from black to white, > 0
  double level;  ///< middle of that range
  double slabMm; ///< >= 0; 0: a single slice
  SlabBlend slabBlend = SlabBlend::Maximum;
  bool inverted = false; ///< true exchanges black and white
  SliceTurn turn = {};
};

/// The grey scale of slices that nobody has changed.
struct SliceGrays
{
  std::array<double, 2> windowLevel; ///< as in SliceRequest
  bool inverted;
};

/// Window and level by the histogram of a volume.
std::array<double, 2> AutomaticWindow(
  const LoadedVolume& volume, const ImageStatistics& statistics);

/// The grey scale that suits a volume: window and level of its file, otherwise of its histogram.
/// Inverted are images whose file says so, and PET, as is usual: the more tracer, the darker.
SliceGrays SuggestedGrays(const LoadedVolume& volume, const ImageStatistics& statistics);

/// Grey pixels, row by row from the upper left. Voxels are interpolated linearly; outside the
/// volume the image is black, inverted or not.
std::vector<std::uint8_t> SlicePicture(vtkImageData* image, const SliceRequest& request);

/// True for indices from the first to the last voxel along each axis. False for NaN.
/// @param extent  as in vtkImageData
bool IsWithin(const glm::dvec3& index, const int* extent);

/// The pixels of a slice in a volume, as continuous indices of its voxels.
class SliceGrid
{
public:
  SliceGrid(vtkImageData* image, const SliceRequest& request);

  /// Index at the centre of a pixel.
  glm::dvec3 IndexAt(int column, int row) const;

  /// Difference of the indices of two points that lie this far apart along the normal.
  glm::dvec3 Through(double distanceMm) const { return distanceMm * this->throughPerMm; }

  /// True for indices within the volume.
  bool Holds(const glm::dvec3& index) const { return IsWithin(index, this->extent); }

private:
  const int* extent;
  glm::dvec3 first; ///< index at the centre of the upper left pixel
  glm::dvec3 right; ///< from a pixel to the next
  glm::dvec3 down;
  glm::dvec3 throughPerMm;
};

/// The thickness and the greys of a slice, as in SliceRequest.
struct SlabLook
{
  double window;
  double level;
  double slabMm;
  SlabBlend slabBlend;
  bool inverted;
};

/// The greys of the pixels of a plane or curved slice. Voxels are interpolated linearly; outside
/// the volume the image is black, inverted or not.
class SlabSampler
{
public:
  SlabSampler(vtkImageData* image, const SlabLook& look);
  ~SlabSampler();
  SlabSampler(const SlabSampler&) = delete;
  SlabSampler& operator=(const SlabSampler&) = delete;

  /// Distance of the samples through the slab.
  double StepMm() const { return this->stepMm; }

  /// @param index    continuous index of the voxels at the middle of the slab
  /// @param through  difference of the indices of a sample and the next
  std::uint8_t GrayAt(const glm::dvec3& index, const glm::dvec3& through) const;

private:
  std::optional<double> BlendedThrough(const glm::dvec3& index, const glm::dvec3& through) const;
  double Blended(double a, double b) const;
  std::optional<double> ValueAt(const glm::dvec3& index) const;

  SlabLook look;
  const int* extent;
  double stepMm;
  int steps; ///< samples on each side of the middle
  vtkNew<vtkImageInterpolator> interpolator;
};

/// Which of the slices of an image is shown.
struct SliceNumber
{
  int number; ///< from 1, in the order of the voxels
  int count;
};

/// The slice through a point in world space [mm], limited to the image. Empty if the image's axes
/// are oblique to the plane, which then cuts several of its slices.
std::optional<SliceNumber> SliceNumberAt(
  vtkImageData* image, SlicePlane plane, const std::array<double, 3>& pointMm);

/// The distance between neighbouring slices [mm]: the spacing of the axis that is nearest to the
/// plane's normal.
double SliceStepMm(vtkImageData* image, SlicePlane plane);

/// The slice that shows a single image, such as a radiograph: an anatomical plane, and the turn
/// that lays it into the plane of the image.
struct SingleImage
{
  SlicePlane plane;
  SliceTurn turn;
};

/// Empty for a volume of several slices.
std::optional<SingleImage> SingleImageOf(vtkImageData* volume);

/// The turn of the slices when a volume is opened: that of a single image, or else none.
SliceTurn FirstTurnOf(vtkImageData* volume);

}

#endif
