#ifndef Varimarch_Scene_CurvedPicture_h
#define Varimarch_Scene_CurvedPicture_h

#include "Scene/CurvePath.h"
#include "Scene/SlabSampler.h"

#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// A volume that is straightened along a curve: the curve runs through the middle row from left to
/// right, and each column shows the line across it. Both have the same scale, so that distances
/// along the curve and across it are right; others are right along a stretched curve only.
struct CurvedRequest
{
  double mmPerPixel; ///< > 0
  int width;         ///< pixels
  int height;
  double turnDegrees; ///< turns the lines across the curve about it, see CurvePath::At
  SlabLook look;      ///< the slab is perpendicular to the curve and to the lines
};

/// Grey pixels, row by row from the upper left. Columns beyond the end of the curve are black.
std::vector<std::uint8_t> CurvedPicture(
  vtkImageData* image, const CurvePath& path, const CurvedRequest& request);

/// The point that a pixel shows in the middle of the slab, in world space [mm].
/// @param column, row  continuous; the centre of the upper left pixel is at 0.5, 0.5
glm::dvec3 PointInCurved(
  const CurvePath& path, const CurvedRequest& request, double column, double row);

}

#endif
