#ifndef Varimarch_Readers_Images_TiffEntries_h
#define Varimarch_Readers_Images_TiffEntries_h

#include "Readers/BinaryHeader.h"
#include "Readers/Images/TiffFile.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace varimarch
{

/// An entry of a directory, of which libtiff tells nothing for the private tags of programs.
struct TiffEntry
{
  int type;            ///< the number of a type, such as 4 for LONG
  std::uint64_t count; ///< number of values
  std::uint64_t value; ///< the value itself, or the file offset of several
};

/// The entries of the first directory of a TIFF file, as they are stored.
class TiffEntries
{
public:
  explicit TiffEntries(const TiffFile& file);

  /// The entry of a tag; nothing if the directory has none.
  std::optional<TiffEntry> At(int tag) const;

  /// Bytes of the file from an offset on; less at its end.
  BinaryHeader BytesAt(std::uint64_t offset, std::size_t count) const;

private:
  std::string path;
  bool isBigEndian;
  std::map<int, TiffEntry> entries;
};

}

#endif
