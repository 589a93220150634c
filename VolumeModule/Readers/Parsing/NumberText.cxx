#include "Readers/Parsing/NumberText.h"

#include "Readers/FileError.h"

#include <vtkSetGet.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <type_traits>

namespace varimarch
{
namespace
{

/// The words of a byte stream, one after another.
class WordStream
{
public:
  explicit WordStream(ByteStream& bytes)
    : bytes(bytes)
    , buffer(1 << 16)
  {
  }

  /// The next word, empty at the end.
  const std::string& Next()
  {
    this->word.clear();
    for (char character; this->Take(character);)
    {
      const bool isGap = character == ',' || (character >= 0 && character <= ' ');
      if (!isGap)
      {
        this->word += character;
      }
      else if (!this->word.empty())
      {
        break;
      }
      // No number is this long, so the file is not text; reading it all as one word would waste
      // memory.
      if (this->word.size() > 1000)
      {
        break;
      }
    }
    return this->word;
  }

private:
  bool Take(char& character)
  {
    if (this->next == this->end)
    {
      this->next = 0;
      this->end = this->bytes.Read(this->buffer.data(), this->buffer.size());
      if (this->end == 0)
      {
        return false;
      }
    }
    character = this->buffer[this->next++];
    return true;
  }

  ByteStream& bytes;
  std::vector<char> buffer;
  std::size_t next = 0;
  std::size_t end = 0;
  std::string word;
};

/// Parses the whole word as a number of this type; returns false if that fails.
template <class Number>
bool Parse(const std::string& word, Number& number)
{
  const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end;
}

template <class Value>
void ReadValues(
  const NumberList& list, ByteStream& stream, Value* destination, ReadProgress& progress)
{
  WordStream words(stream);
  for (std::uint64_t left = list.skipped; left > 0; --left)
  {
    words.Next();
  }
  for (std::uint64_t i = 0; i < list.count; ++i)
  {
    if (i % (1 << 20) == 0)
    {
      progress.Report(double(i) / double(list.count));
    }
    const bool isNextGroup = i > 0 && i % list.together == 0;
    for (std::uint64_t left = isNextGroup ? list.together * (list.groups - 1) : 0; left > 0; --left)
    {
      words.Next();
    }
    const std::string& word = words.Next();
    if (word.empty())
    {
      FailToRead(list.path, std::to_string(list.count) + " numbers", std::to_string(i));
    }
    if (!Parse(word, destination[i]))
    {
      FailToRead(list.path,
        std::string("a number of type ") + vtkImageScalarTypeNameMacro(list.scalarType),
        Quoted(word));
    }
  }
}

}

void ReadNumbers(
  const NumberList& list, ByteStream& stream, void* destination, ReadProgress& progress)
{
  switch (list.scalarType)
  {
    vtkTemplateMacro(ReadValues(list, stream, static_cast<VTK_TT*>(destination), progress));
    default:
      FailToRead(list.path, "a scalar type", std::to_string(list.scalarType));
  }
}

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

std::vector<std::string> Words(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::string ShortText(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << number;
  return text.str();
}

double NumberFromText(const std::string& path, const std::string& what, const std::string& word)
{
  double number = 0.0;
  if (!Parse(word, number))
  {
    FailToRead(path, what, Quoted(word));
  }
  return number;
}

std::int64_t IntegerFromText(
  const std::string& path, const std::string& what, const std::string& word)
{
  std::int64_t number = 0;
  if (!Parse(word, number))
  {
    FailToRead(path, what, Quoted(word));
  }
  return number;
}

std::int64_t WholeNumber(double number)
{
  constexpr double Most = 1e15;
  return std::isnan(number) ? 0 : std::int64_t(std::clamp(number, -Most, Most));
}

std::vector<double> NumbersFromText(
  const std::string& path, const std::string& what, const std::string& line, std::size_t count)
{
  const std::vector<std::string> words = Words(line);
  if (words.size() != count)
  {
    FailToRead(path, std::to_string(count) + " numbers for the " + what, Quoted(line));
  }
  std::vector<double> numbers;
  for (const std::string& word : words)
  {
    numbers.push_back(NumberFromText(path, "numbers for the " + what, word));
  }
  return numbers;
}

}
