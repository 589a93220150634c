#ifndef Varimarch_Scene_SlicePicture_h
#define Varimarch_Scene_SlicePicture_h

#include "Scene/Scene.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// The planes of the patient's body.
enum class SlicePlane
{
  Axial,    ///< seen from the feet: the patient's right is at the left, the front is above
  Coronal,  ///< seen from the front: the patient's right is at the left, the head is above
  Sagittal, ///< seen from the patient's left: the front is at the left, the head is above
};

/// World space (LPS) along a slice's picture: where its columns and its rows go, and where from one
/// slice to the next, each of length 1.
struct SliceAxes
{
  std::array<double, 3> right;
  std::array<double, 3> down;
  std::array<double, 3> through;
};

SliceAxes AxesOf(SlicePlane plane);

/// A slice to draw.
struct SliceRequest
{
  SlicePlane plane;
  std::array<double, 3> middleMm; ///< what is at the middle of the picture, in world space
  double mmPerPixel;              ///< > 0
  int width;                      ///< pixels
  int height;
  double window; ///< the range of values from black to white, > 0
  double level;  ///< its middle
  double slabMm; ///< >= 0; 0: a single slice
  SlabBlend slabBlend = SlabBlend::Maximum;
};

/// Gray pixels, row by row from the upper left. Between voxels linear; black beside the volume.
std::vector<std::uint8_t> SlicePicture(vtkImageData* image, const SliceRequest& request);

}

#endif
