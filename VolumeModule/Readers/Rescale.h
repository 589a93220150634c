#ifndef Varimarch_Readers_Rescale_h
#define Varimarch_Readers_Rescale_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// The line that takes stored values to what they stand for.
struct Rescale
{
  double slope = 1.0;
  double intercept = 0.0;
};

/// The image with values slope * stored + intercept. The type is the smallest of short, int, float
/// and double that holds the results exactly, or for a broken slope as precisely as the stored
/// type was. The image itself comes back when there is nothing to do.
/// @param slices  one line for all slices, or one for each
/// @throws std::runtime_error when a wider type does not fit the memory
vtkSmartPointer<vtkImageData> Rescaled(
  const std::string& path, vtkSmartPointer<vtkImageData> image, const std::vector<Rescale>& slices);

}

#endif
