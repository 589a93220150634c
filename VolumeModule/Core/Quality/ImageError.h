#ifndef Varimarch_Core_Quality_ImageError_h
#define Varimarch_Core_Quality_ImageError_h

#include <cstddef>

namespace varimarch
{

/// Difference between an image and the truth, in units of 1/255: 1 is one step of an 8 bit display.
struct ImageError
{
  double rootMeanSquare; ///< over all channels of all pixels
  double percentile999;  ///< 99.9 % of the pixels have no channel with a larger error
  double largest;        ///< largest error of any channel of any pixel
};

/// Compares two images of premultiplied RGBA without background, with channels in [0, 1]. A channel
/// that is not finite in one image counts as infinitely wrong, so that it cannot be overlooked.
/// @param image, truth  4 * pixelCount channels each
/// @param pixelCount  >= 1
/// @throws std::invalid_argument if there are no pixels
ImageError CompareImages(const float* image, const float* truth, std::size_t pixelCount);

}

#endif
