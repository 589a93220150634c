#include "Readers/Images/TiffTags.h"

#include "Readers/VoxelLayout.h"

#include <vtkType.h>

namespace varimarch
{

int TypeOfTiffPixels(TIFF* file)
{
  const auto photometric = TiffTag<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC);
  const bool isPlain = photometric == PHOTOMETRIC_MINISBLACK ||
    photometric == PHOTOMETRIC_MINISWHITE || photometric == PHOTOMETRIC_RGB;
  const auto bits = TiffTag<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE);
  const auto format = TiffTag<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT);
  const NumberKind kind = format == SAMPLEFORMAT_INT ? NumberKind::Signed
    : format == SAMPLEFORMAT_IEEEFP                  ? NumberKind::Float
                                                     : NumberKind::Unsigned;
  const bool isReal = format != SAMPLEFORMAT_COMPLEXINT && format != SAMPLEFORMAT_COMPLEXIEEEFP;
  return isPlain && isReal && bits % 8 == 0 ? ScalarTypeOf(kind, bits / 8) : VTK_VOID;
}

}
