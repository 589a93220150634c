#ifndef Varimarch_Readers_NrrdHeader_h
#define Varimarch_Readers_NrrdHeader_h

#include "Readers/HeaderText.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The fields of an NRRD header. Keys are in lower case without blanks ("spacedirections").
struct NrrdHeader
{
  std::string path;
  HeaderFields fields;
  std::vector<std::string> listedFiles; ///< the lines behind "data file: LIST"
  std::uint64_t end = 0;                ///< offset of what follows the header
};

/// @throws std::runtime_error when the file is no NRRD file or the header is not complete
NrrdHeader ReadNrrdHeader(const std::string& path);

/// Parts of a field's value: words, vectors "(x, y, z)", strings in quotes.
std::vector<std::string> NrrdParts(const std::string& value);

/// NRRD has "unsigned short" and "unsignedshort", "data file" and "datafile".
std::string WithoutBlanks(std::string text);

}

#endif
