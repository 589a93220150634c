#include "Readers/Dicom/Attributes.h"

#include <charconv>
#include <system_error>

namespace varimarch
{

std::optional<double> NumberIn(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" +");
  const std::size_t last = text.find_last_not_of(' ');
  if (begin == std::string::npos)
  {
    return std::nullopt;
  }
  double number = 0.0;
  const char* const end = text.data() + last + 1;
  const auto [parsed, error] = std::from_chars(text.data() + begin, end, number);
  const bool isNumber = error == std::errc() && parsed == end && std::isfinite(number);
  return isNumber ? std::optional<double>(number) : std::nullopt;
}

}
