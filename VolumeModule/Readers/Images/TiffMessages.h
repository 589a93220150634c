#ifndef Varimarch_Readers_Images_TiffMessages_h
#define Varimarch_Readers_Images_TiffMessages_h

#include "Readers/Images/TiffFile.h"

#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <string>

namespace varimarch
{

/// Collects libtiff's errors, which it would otherwise print.
struct TiffFile::Messages
{
  std::string first;

  static int Take(TIFF*, void* self, const char*, const char* format, va_list arguments)
  {
    char text[200];
    std::vsnprintf(text, sizeof(text), format, arguments);
    std::string& first = static_cast<Messages*>(self)->first;
    first = first.empty() ? text : first;
    return 1;
  }

  static int Ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

}

#endif
