#ifndef Varimarch_Core_Quality_PerceptualError_h
#define Varimarch_Core_Quality_PerceptualError_h

#include <array>

namespace varimarch
{

/// Measures of how different two images look on a display; ImageError measures how wrong they are.
/// Displayed colours are sRGB in [0, 1].

/// A colour in CIE L*a*b* for daylight D65; lightness is in [0, 100].
struct LabColor
{
  double lightness;
  double a; ///< from green to red
  double b; ///< from blue to yellow
};

/// Converts a displayed colour to L*a*b*, by IEC 61966-2-1 and CIE 15.
LabColor LabFromDisplay(const std::array<double, 3>& rgb);

/// The CIEDE2000 difference with all weights 1; about 1 is just visible. Source: G. Sharma, W. Wu,
/// E. Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test
/// data, and mathematical observations", Color Research and Application 30(1), 2005; eq. 2 to 22.
double ColorDifference(const LabColor& first, const LabColor& second);

struct PerceptualError
{
  double structuralSimilarity; ///< mean SSIM of the luma, at most 1 for equal images
  double meanColorDifference;  ///< mean CIEDE2000 difference
  double colorDifference99;    ///< CIEDE2000 difference that 99 % of the pixels do not exceed
};

/// Two images of premultiplied RGBA, row by row, and the background that a display shows behind
/// them.
struct DisplayedPair
{
  const float* image; ///< 4 * width * height channels
  const float* truth; ///< 4 * width * height channels
  int width;
  int height;
  std::array<double, 3> background; ///< displayed behind both images
};

/// Compares two images over their background, clamped to [0, 1] but not rounded to bytes; NaN
/// counts as 0. SSIM is that of Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, "Image quality
/// assessment: from error visibility to structural similarity", IEEE Transactions on Image
/// Processing 13(4), 2004: Gaussian windows of 11 x 11 pixels with deviation 1.5 that lie
/// completely inside the image, K1 = 0.01, K2 = 0.03. If a side is shorter than 11 pixels, the
/// window has its length.
/// @throws std::invalid_argument if there are no pixels
PerceptualError ComparePerceived(const DisplayedPair& pair);

}

#endif
