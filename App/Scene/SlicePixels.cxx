#include "Scene/SlicePixels.h"

#include "Scene/ImageStatistics.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The middle slice as a volume of its own.
vtkSmartPointer<vtkImageData> MiddleSliceOf(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  extent[4] = extent[5] = (extent[4] + extent[5] + 1) / 2;
  auto slice = vtkSmartPointer<vtkImageData>::New();
  slice->ShallowCopy(image);
  slice->Crop(extent);
  return slice;
}

}

GrayPicture MiddleSlice(vtkImageData* image)
{
  const vtkSmartPointer<vtkImageData> slice = MiddleSliceOf(image);
  const ImageStatistics statistics(slice);
  const double black = statistics.Percentile(1.0);
  const double white = std::max(statistics.Percentile(99.0), black + 1e-9);
  const int* const extent = slice->GetExtent();
  GrayPicture picture = { slice->GetDimensions()[0], slice->GetDimensions()[1], {} };
  picture.pixels.reserve(std::size_t(slice->GetNumberOfPoints()));
  for (int y = extent[2]; y <= extent[3]; ++y)
  {
    for (int x = extent[0]; x <= extent[1]; ++x)
    {
      const double value = slice->GetScalarComponentAsDouble(x, y, extent[4], 0);
      const double part = (value - black) / (white - black);
      picture.pixels.push_back(
        std::isnan(part) ? 0 : std::uint8_t(std::lround(255.0 * std::clamp(part, 0.0, 1.0))));
    }
  }
  return picture;
}

}
