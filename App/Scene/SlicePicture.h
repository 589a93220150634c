#ifndef Varimarch_Scene_SlicePicture_h
#define Varimarch_Scene_SlicePicture_h

#include "Scene/ImageStatistics.h"
#include "Scene/Scene.h"
#include "Scene/SliceAxes.h"
#include "Scene/VolumeLoading.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

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

}

#endif
