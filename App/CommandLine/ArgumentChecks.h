#ifndef Varimarch_CommandLine_ArgumentChecks_h
#define Varimarch_CommandLine_ArgumentChecks_h

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Parses a text such as "640x480". Empty unless it has `count` integers, each from smallest to
/// largest.
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

/// A sentence for the user that says why Sides rejects a text; empty if it accepts it.
/// @param example  an accepted text, such as "640x480"
template <std::size_t count>
std::string SidesProblem(
  const std::string& text, const std::string& example, int smallest, int largest)
{
  return Sides<count>(text, smallest, largest)
    ? std::string()
    : "expected a size such as " + example + ", each side from " + std::to_string(smallest) +
      " to " + std::to_string(largest) + ", found \"" + text + "\"";
}

/// A sentence for the user that suggests the nearest name for an unknown one; empty if the text is
/// one of the names.
std::string NameProblem(const std::string& text, const std::vector<std::string>& names);

/// Rejects a file or folder that exists, unless the user has asked for another in its place.
/// @throws std::runtime_error that names it
void CheckMayReplace(const std::string& path, bool overwrites);

}

#endif
