#ifndef Varimarch_CommandLine_Validators_h
#define Varimarch_CommandLine_Validators_h

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// "640x480" as its numbers; empty when it is not `count` whole numbers within the limits.
template <std::size_t count>
std::optional<std::array<int, count>> Sides(const std::string& text, int smallest, int largest)
{
  std::array<int, count> sides;
  const char* position = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto [next, error] = std::from_chars(position, end, sides[i]);
    const bool last = i + 1 == count;
    if (error != std::errc() || sides[i] < smallest || sides[i] > largest ||
      (last ? next != end : next == end || *next != 'x'))
    {
      return std::nullopt;
    }
    position = next + 1;
  }
  return sides;
}

/// Accepts what Sides does.
/// @param example  for the message: "640x480"
template <std::size_t count>
CLI::Validator SidesValidator(const std::string& example, int smallest, int largest)
{
  const auto check = [=](std::string& text)
  {
    return Sides<count>(text, smallest, largest)
      ? std::string()
      : "expected a size such as " + example + ", each side from " + std::to_string(smallest) +
        " to " + std::to_string(largest) + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

/// Accepts finite numbers that are larger.
CLI::Validator Above(double limit);

/// Accepts only these names, suggests the nearest for others, and lists them in the help.
CLI::Validator NameValidator(const std::vector<std::string>& names);

}

#endif
