#ifndef Varimarch_Scene_CsvText_h
#define Varimarch_Scene_CsvText_h

#include <iomanip>
#include <sstream>
#include <string>

namespace varimarch
{

/// A text as a field of a CSV table, as in RFC 4180: in quotes, and quotes within it doubled.
inline std::string QuotedForCsv(const std::string& text)
{
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

}

#endif
