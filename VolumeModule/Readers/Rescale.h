#ifndef Varimarch_Readers_Rescale_h
#define Varimarch_Readers_Rescale_h

#include "Readers/VolumeFile.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// The linear map from stored values to physical ones.
struct Rescale
{
  double slope = 1.0;
  double intercept = 0.0;
};

/// Replaces all values by slope * stored + intercept. The result has the smallest type of short,
/// int, float and double that holds the values exactly or, for a fractional slope, with the
/// precision of the stored type. Returns the image itself if there is nothing to do.
/// @param slices  one map for all slices, or one per slice
/// @throws std::runtime_error if a wider type does not fit in memory
vtkSmartPointer<vtkImageData> Rescaled(
  const std::string& path, vtkSmartPointer<vtkImageData> image, const std::vector<Rescale>& slices);

/// Replaces the components of each voxel by their magnitude, the root of the sum of their squares,
/// as a float or, for components of more than 24 bits, a double. Adds a warning.
/// @param reason  beginning of the warning, such as "The numbers are complex"
void TakeMagnitude(const std::string& reason, Volume& volume);

}

#endif
