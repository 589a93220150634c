#ifndef Varimarch_Readers_Parsing_BinaryHeader_h
#define Varimarch_Readers_Parsing_BinaryHeader_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>

namespace varimarch
{

/// The bytes at the beginning of a file, which hold numbers at known offsets.
class BinaryHeader
{
public:
  /// Reads a header, decompressed if necessary.
  /// @throws std::runtime_error if the file has fewer bytes
  BinaryHeader(const std::string& path, std::size_t byteCount, bool isBigEndian);

  /// Bytes that were read elsewhere.
  BinaryHeader(std::string bytes, bool isBigEndian)
    : bytes(std::move(bytes))
    , isBigEndian(isBigEndian)
  {
  }

  /// The number at an offset; 0 if it reaches beyond the header.
  template <class Number>
  Number At(std::size_t offset) const
  {
    Number number = 0;
    this->Take(offset, &number, sizeof(number));
    return number;
  }

  /// Three adjacent numbers.
  template <class Number>
  glm::dvec3 VectorAt(std::size_t offset) const
  {
    return { double(this->At<Number>(offset)), double(this->At<Number>(offset + sizeof(Number))),
      double(this->At<Number>(offset + 2 * sizeof(Number))) };
  }

  const std::string& Bytes() const { return this->bytes; }

private:
  /// Copies bytes, in the order of the machine, into a number that is 0.
  void Take(std::size_t offset, void* number, std::size_t byteCount) const;

  std::string bytes;
  bool isBigEndian;
};

}

#endif
