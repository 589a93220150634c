#ifndef Varimarch_Readers_NumberText_h
#define Varimarch_Readers_NumberText_h

#include "Readers/ByteStream.h"
#include "Readers/VolumeFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// How many numbers of which type to expect in which file.
struct NumberList
{
  std::string path;
  int scalarType; ///< VTK_SHORT and the like
  std::uint64_t count;
};

/// Reads decimal numbers between blanks or commas into memory for values of that type.
/// @throws std::runtime_error for too few numbers, or one that the type cannot hold
/// @throws ReadCancelled
void ReadNumbers(
  const NumberList& list, ByteStream& stream, void* destination, ReadProgress& progress);

/// The words of a line: parts without blanks.
std::vector<std::string> Words(const std::string& line);

/// A word as a number, independent of the locale.
/// @throws std::runtime_error, naming the file and `what` was expected, unless it is just that
double NumberFromText(const std::string& path, const std::string& what, const std::string& word);
std::int64_t IntegerFromText(
  const std::string& path, const std::string& what, const std::string& word);

/// The words of a line as exactly so many numbers.
/// @throws std::runtime_error otherwise
std::vector<double> NumbersFromText(
  const std::string& path, const std::string& what, const std::string& line, std::size_t count);

}

#endif
