#include "Regression/PictureJudgement.h"

#include "Scene/Images/ImageFiles.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkSmartPointer<vtkImageData> BytesOverBackground(const std::vector<float>& rgba,
  const std::array<int, 2>& size, const std::array<double, 3>& background)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  std::copy(rgba.begin(), rgba.end(), static_cast<float*>(image->GetScalarPointer()));
  return varimarch::BytesOver(image, background);
}

namespace
{

// Opaque pixels with channels in [0, 1].
std::vector<float> OpaquePixels(vtkImageData* bytes)
{
  const auto* const channels = static_cast<const unsigned char*>(bytes->GetScalarPointer());
  std::vector<float> rgba(4 * std::size_t(bytes->GetNumberOfPoints()), 1.0f);
  for (std::size_t i = 0; i < rgba.size(); ++i)
  {
    rgba[i] = i % 4 == 3 ? 1.0f : float(channels[i / 4 * 3 + i % 4]) / 255.0f;
  }
  return rgba;
}

}

varimarch::ImageError DifferenceOfBytes(vtkImageData* picture, vtkImageData* baseline)
{
  const std::vector<float> drawn = OpaquePixels(picture);
  const std::vector<float> expected = OpaquePixels(baseline);
  varimarch::ImageError error =
    varimarch::CompareImages(drawn.data(), expected.data(), drawn.size() / 4);
  // The opacities, which are always equal, do not count.
  error.rootMeanSquare *= std::sqrt(4.0 / 3.0);
  return error;
}

std::string FaultsOf(vtkImageData* picture, vtkImageData* baseline, double allowed999)
{
  const int* const size = picture->GetDimensions();
  const int* const expected = baseline->GetDimensions();
  std::ostringstream faults;
  if (size[0] != expected[0] || size[1] != expected[1])
  {
    faults << "The picture has " << size[0] << " x " << size[1] << " pixels, expected "
           << expected[0] << " x " << expected[1] << ". ";
    return faults.str();
  }
  const varimarch::ImageError error = DifferenceOfBytes(picture, baseline);
  if (!(error.rootMeanSquare <= AllowedRmse))
  {
    faults << "The RMSE is " << error.rootMeanSquare << " of 255, allowed are " << AllowedRmse
           << ". ";
  }
  if (!(error.percentile999 <= allowed999))
  {
    faults << "0.1 % of the pixels are off by more than " << error.percentile999
           << " of 255, allowed are " << allowed999 << ". ";
  }
  return faults.str();
}
