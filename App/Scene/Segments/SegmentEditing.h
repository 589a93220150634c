#ifndef Varimarch_Scene_SegmentEditing_h
#define Varimarch_Scene_SegmentEditing_h

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// A change of the voxels of LabelMap::image: the numbers in a box before and after it. It takes
/// two bytes for each voxel of the box, however large the image is.
struct LabelChange
{
  std::array<int, 6> box = {};      ///< voxels, counted from 0: first x, last x, first y, ...
  std::vector<std::uint8_t> before; ///< x fastest; empty if nothing changes
  std::vector<std::uint8_t> after;

  bool IsEmpty() const { return this->before.empty(); }
};

/// Writes the numbers of a change into an image, those after it or those before it.
void Apply(const LabelChange& change, bool isForward, vtkImageData* numbers);

/// The change that two changes make, one after the other.
/// @param numbers  the image after both
LabelChange Joined(const LabelChange& first, const LabelChange& second, vtkImageData* numbers);

// Each function returns a change and leaves the images. A number is that of a segment, from 1 on.

/// Adds the voxels without a segment whose values lie in a range, and which are connected through
/// faces with the voxel at a point by such values. Empty if that voxel's value lies outside.
/// @param scan      the volume on the grid of the numbers; the first component counts
/// @param pointMm   in world space
/// @param range     smallest and largest value
LabelChange ConnectedRegion(vtkImageData* numbers, int number, vtkImageData* scan,
  const std::array<double, 3>& pointMm, const std::array<double, 2>& range);

/// A stroke of a round brush in a slice.
struct BrushStroke
{
  std::array<double, 3> fromMm; ///< both ends in world space
  std::array<double, 3> toMm;
  std::array<double, 3> normal; ///< unit normal of the slice
  double radiusMm;              ///< > 0
};

/// Paints the voxels of the slice within a radius of a line. Other segments are painted over.
LabelChange Painted(vtkImageData* numbers, int number, const BrushStroke& stroke);

/// Takes a stroke away from one segment.
LabelChange Erased(vtkImageData* numbers, int number, const BrushStroke& stroke);

/// Keeps only the largest part of a segment, connected through faces.
LabelChange LargestIsland(vtkImageData* numbers, int number);

/// Removes the parts of a segment that are smaller than a volume [ml].
LabelChange WithoutSmallIslands(vtkImageData* numbers, int number, double leastMl);

/// Smooths the surface of a segment: its voxels are those where a Gauss filter of its voxels, whose
/// standard deviation is given [mm], is more than a half. Other segments keep their voxels.
LabelChange Smoothed(vtkImageData* numbers, int number, double deviationMm);

}

#endif
