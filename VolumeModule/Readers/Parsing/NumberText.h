#ifndef Varimarch_Readers_Parsing_NumberText_h
#define Varimarch_Readers_Parsing_NumberText_h

#include "Readers/Packed/ByteStream.h"
#include "Readers/VolumeFile.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A list of numbers to read from a file.
struct NumberList
{
  std::string path;
  int scalarType; ///< VTK_SHORT or another VTK type
  std::uint64_t count;
  std::uint64_t together = 1; ///< numbers that stand together
  std::uint64_t groups = 1;   ///< groups of such numbers, of which one is in the list
  std::uint64_t skipped = 0;  ///< numbers before the first of the list
};

/// Reads decimal numbers, separated by whitespace or commas, into memory of the list's type.
/// @throws std::runtime_error if there are too few numbers, or the type cannot hold one
/// @throws ReadCancelled
void ReadNumbers(
  const NumberList& list, ByteStream& stream, void* destination, ReadProgress& progress);

/// The words of a line, separated by whitespace.
std::vector<std::string> Words(const std::string& line);

/// The number that a text is, independent of the locale; none if it is anything else.
std::optional<double> NumberIn(const std::string& text);

/// A number with at most four significant digits, for sentences.
std::string ShortText(double number);

/// Converts a word to a number, independent of the locale.
/// @param what  description of the number for the error message
/// @throws std::runtime_error if the word is not exactly one number
double NumberFromText(const std::string& path, const std::string& what, const std::string& word);
std::int64_t IntegerFromText(
  const std::string& path, const std::string& what, const std::string& word);

/// A number without its fraction; 0 for NaN. Numbers beyond 1e15, which count nothing in a file,
/// become that.
std::int64_t WholeNumber(double number);

/// Converts the words of a line to exactly `count` numbers.
/// @throws std::runtime_error if it has other words, or another number of them
std::vector<double> NumbersFromText(
  const std::string& path, const std::string& what, const std::string& line, std::size_t count);

}

#endif
