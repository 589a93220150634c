#ifndef Varimarch_Readers_Packed_Unpacking_h
#define Varimarch_Readers_Packed_Unpacking_h

#include "Readers/VolumeFile.h"

#include <string>
#include <vector>

namespace varimarch
{

/// An archive, a compressed file, or a folder with compressed files, and a place for copies.
struct UnpackingOrder
{
  std::string path;
  std::string folder; ///< an empty folder
  double spaceBytes;  ///< space for the copies
};

/// Copies in the folder of an order.
struct UnpackedContent
{
  std::string path;                  ///< the file or folder to read in place of the packed one
  std::vector<std::string> warnings; ///< sentences about what was left out
};

/// Unpacks. Links, and files whose paths lead out of their archive, are left out.
/// @throws std::runtime_error if the content is corrupt, encrypted, or does not fit in the space
/// @throws ReadCancelled
UnpackedContent Unpack(const UnpackingOrder& order, ReadProgress& progress);

}

#endif
