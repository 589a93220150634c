#ifndef Varimarch_Readers_Images_TiffTags_h
#define Varimarch_Readers_Images_TiffTags_h

#include <tiffio.h>

#include <cstdint>

namespace varimarch
{

/// A tag's value in the current directory, or its default according to the TIFF specification.
template <class Value>
Value TiffTag(TIFF* file, std::uint32_t tag)
{
  Value value = 0;
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

/// The VTK type of pixels that are stored as numbers; VTK_VOID for colours of another kind.
int TypeOfTiffPixels(TIFF* file);

}

#endif
