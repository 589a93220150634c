#ifndef Varimarch_Core_Quality_PerceptualError_h
#define Varimarch_Core_Quality_PerceptualError_h

#include <array>

namespace varimarch
{

/// Measures of how different two pictures look on a display, beside ImageError, which says how
/// wrong they are. Displayed colours are sRGB from 0 to 1.

/// Lightness from 0 to 100, and the two opponent colours, for daylight D65.
struct LabColor
{
  double lightness;
  double a; ///< green to red
  double b; ///< blue to yellow
};

/// CIE L*a*b* of a displayed colour: IEC 61966-2-1 and CIE 15.
LabColor LabFromDisplay(const std::array<double, 3>& rgb);

/// CIEDE2000 with all weights 1; about 1 can just be seen. G. Sharma, W. Wu, E. Dalal, "The
/// CIEDE2000 color-difference formula: implementation notes, supplementary test data, and
/// mathematical observations", Color Research and Application 30(1), 2005; eq. 2 to 22.
double ColorDifference(const LabColor& first, const LabColor& second);

struct PerceptualError
{
  double structuralSimilarity; ///< mean SSIM of the luma, at most 1, which equal pictures have
  double meanColorDifference;  ///< CIEDE2000
  double colorDifference99;    ///< 99 of 100 pixels differ by no more
};

/// Two pictures of premultiplied RGBA, row by row, as a display shows them.
struct DisplayedPair
{
  const float* image; ///< 4 * width * height channels
  const float* truth; ///< the same
  int width;
  int height;
  std::array<double, 3> background; ///< displayed behind both
};

/// Compares them on their background, cut off at 0 and 1 but not rounded to bytes; what is not a
/// number is shown as 0. SSIM is that of Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, "Image
/// quality assessment: from error visibility to structural similarity", IEEE Transactions on Image
/// Processing 13(4), 2004: Gaussian windows of 11 x 11 pixels and deviation 1.5 that lie wholly in
/// the picture, K1 = 0.01, K2 = 0.03. Where a side has fewer pixels than 11, the window has as
/// many.
/// @throws std::invalid_argument for no pixels
PerceptualError ComparePerceived(const DisplayedPair& pair);

}

#endif
