#ifndef Varimarch_Benchmarks_Comparison_SliceMethod_h
#define Varimarch_Benchmarks_Comparison_SliceMethod_h

#include "ComparedView.h"

namespace varimarch
{

/// The proxy geometry that is drawn with the volume's look.
enum class Slices
{
  Object,   ///< across the axis of the grid that is nearest to the view, from a 3D texture
  Object2D, ///< the slices of the volume themselves, as 2D textures: three stacks of them
  View,     ///< parallel to the image
  Shells,   ///< spheres around the eye; parallel to the image in a parallel projection
};

/// Slice-based volume rendering: T. Gorkin, "Volume rendering using graphics hardware" (2009),
/// slides 14 to 26. A slice stands for the layer around it, of the same thickness wherever a ray
/// crosses it, as it does there; so slices across an axis of the volume look thinner from aside.
///
/// Draws into the bound image, whose blending is "over" for slices from the back to the front, and
/// "under" for slices from the front to the back.
void DrawSlices(const ComparisonFrame& frame, Slices slices, bool fromBehind);

/// The same with slices parallel to the image, whose colours are multiplied by the light at their
/// places.
/// @param light  parts of a light that arrive, at points from corner to corner of the volume's box
void DrawLitSlices(const ComparisonFrame& frame, vtkTextureObject* light, bool fromBehind);

}

#endif
