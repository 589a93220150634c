#ifndef Varimarch_Readers_Pyramids_ZarrHeader_h
#define Varimarch_Readers_Pyramids_ZarrHeader_h

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The description of an array of Zarr version 2, in its file .zarray.
struct ZarrHeader
{
  std::vector<std::int64_t> shape; ///< slowest index first, as in Python
  std::vector<std::int64_t> chunk;
  int scalarType = 0; ///< a VTK type
  bool isBigEndian = false;
  bool isFortran = false; ///< True if the first index runs fastest in a chunk.
  std::string separator;  ///< between the indices in the name of a chunk
  std::string codec;      ///< name of the compression; empty for none
  std::vector<char> fill; ///< the value of voxels without a chunk, in the machine's byte order
};

/// The files that mark a folder as Zarr.
constexpr const char* ZarrArrayFile = ".zarray";
constexpr const char* ZarrAttributesFile = ".zattrs";
constexpr const char* ZarrGroupFile = ".zgroup";
constexpr const char* ZarrOfVersion3 = "zarr.json";

/// Reads the description of the array in a folder.
/// @throws std::runtime_error if there is none, or one of an array that cannot be read
ZarrHeader ReadZarrHeader(const std::string& folder);

/// Decompresses the file of a chunk, which must fill the memory exactly.
/// @throws std::runtime_error otherwise
void ReadZarrChunk(const std::string& path, const std::string& codec, std::vector<char>& chunk);

}

#endif
