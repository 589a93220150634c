#ifndef Varimarch_Readers_Images_Picture_h
#define Varimarch_Readers_Images_Picture_h

#include "Readers/VoxelLayout.h"

#include <array>
#include <string>

namespace varimarch
{

/// A file with one picture: PNG, JPEG, BMP, or TIFF of one page.
struct Picture
{
  std::string path;
  VoxelLayout layout;                             ///< one slice
  std::array<double, 2> spacingMm = { 0.0, 0.0 }; ///< 0 if unknown
  int orientation = 1;                            ///< as in StackGeometry
};

/// Reads what a file says about its picture.
/// @throws std::runtime_error if the file is damaged
Picture InspectedPicture(const std::string& path);

/// Decodes a picture, top row first, into memory of its layout.
/// @throws std::runtime_error if the file is damaged
void ReadPicture(const Picture& picture, void* destination);

}

#endif
