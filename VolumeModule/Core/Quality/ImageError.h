#ifndef Varimarch_Core_Quality_ImageError_h
#define Varimarch_Core_Quality_ImageError_h

#include <cstddef>

namespace varimarch
{

/// How far an image is from the truth, in units of 1/255: 1 is one step of an 8 bit display.
struct ImageError
{
  double rootMeanSquare; ///< over all channels of all pixels
  double percentile999;  ///< 99.9 of 100 pixels have no channel that is further off
  double largest;        ///< of any channel of any pixel
};

/// Compares two images of premultiplied RGBA before the background, where the maximum is 1. What is
/// not finite in one of them is infinitely wrong, so that it cannot be overlooked.
/// @param image, truth  4 * pixelCount channels each
/// @param pixelCount    >= 1
/// @throws std::invalid_argument for no pixels
ImageError CompareImages(const float* image, const float* truth, std::size_t pixelCount);

}

#endif
