#ifndef Varimarch_Scene_ValueGradientHistogram_h
#define Varimarch_Scene_ValueGradientHistogram_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// How often values and gradient magnitudes occur together in a volume.
struct ValueGradientHistogram
{
  static constexpr int Columns = 512; ///< bins of the value
  static constexpr int Rows = 256;    ///< bins of the gradient magnitude

  /// Number of voxels with a value and a gradient; 0 outside of the ranges.
  std::int64_t CountAt(double value, double gradient) const;

  std::array<double, 2> values = { 0.0, 1.0 }; ///< first and last finite value
  double largestGradient = 1.0;     ///< [units of the data per mm]; larger ones count as it
  std::vector<std::int64_t> counts; ///< rows of columns, from the gradient 0 on
};

/// Counts the voxels for which there are gradient magnitudes. Values that are not finite are left
/// out.
/// @param magnitudes  those of the volume, see GradientMagnitudes
ValueGradientHistogram HistogramOf(vtkImageData* volume, vtkImageData* magnitudes);

/// Gradient magnitudes of a volume's first component [units of the data per mm], for a histogram.
/// They are taken at up to about four million voxels spread over the volume, by the mapper's
/// central differences. A voxel with a neighbour that is not finite gets 0.
vtkSmartPointer<vtkImageData> GradientMagnitudes(vtkImageData* image);

/// Distance between the voxels that have magnitudes, along each axis [voxels].
vtkIdType StrideOfMagnitudes(vtkImageData* image);

}

#endif
