#ifndef Varimarch_Frame_Fingerprint_h
#define Varimarch_Frame_Fingerprint_h

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace varimarch
{

/// Everything that something was made from, such as an image, a table or a lattice: it must be made
/// again if, and only if, the fingerprint of its inputs is another. Inputs are numbers, choices,
/// lists of inputs, structs with a function FieldsOf, and objects, which count by their addresses
/// and belong beside the times of their last changes.
///
/// FieldsOf ties all members of a struct. It begins with a structured binding that names them, so
/// that a new member does not compile until it is there:
/// @code
///   auto FieldsOf(const Window& window)
///   {
///     const auto& [width, level] = window;
///     return std::tie(width, level);
///   }
/// @endcode
class Fingerprint
{
public:
  Fingerprint() = default;

  template <class... Inputs>
  explicit Fingerprint(const Inputs&... inputs)
  {
    (this->Add(inputs), ...);
  }

  /// Adds a number, a choice, an object, or a struct with a function FieldsOf.
  template <class Input>
  void Add(const Input& input)
  {
    if constexpr (std::is_floating_point_v<Input>)
    {
      this->AddNumber(double(input));
    }
    else if constexpr (std::is_pointer_v<Input>)
    {
      this->words.push_back(std::uint64_t(reinterpret_cast<std::uintptr_t>(input)));
    }
    else if constexpr (std::is_arithmetic_v<Input> || std::is_enum_v<Input>)
    {
      this->words.push_back(std::uint64_t(input));
    }
    else
    {
      std::apply([this](const auto&... fields) { (this->Add(fields), ...); }, FieldsOf(input));
    }
  }

  template <int Length, class Number, glm::qualifier Precision>
  void Add(const glm::vec<Length, Number, Precision>& vector)
  {
    for (int i = 0; i < Length; ++i)
    {
      this->Add(vector[i]);
    }
  }

  template <int Columns, int Rows, class Number, glm::qualifier Precision>
  void Add(const glm::mat<Columns, Rows, Number, Precision>& matrix)
  {
    for (int column = 0; column < Columns; ++column)
    {
      this->Add(matrix[column]);
    }
  }

  template <class Input>
  void Add(const std::vector<Input>& list)
  {
    this->AddAll(list);
  }

  template <class Input, std::size_t Length>
  void Add(const std::array<Input, Length>& list)
  {
    this->AddAll(list);
  }

  template <class Input>
  void Add(const std::optional<Input>& input)
  {
    this->Add(input.has_value());
    if (input)
    {
      this->Add(*input);
    }
  }

  void Add(const std::string& text) { this->AddAll(text); }

  void Add(const Fingerprint& other) { this->AddAll(other.words); }

  bool IsEmpty() const { return this->words.empty(); }

  bool operator==(const Fingerprint& other) const { return this->words == other.words; }
  bool operator!=(const Fingerprint& other) const { return !(*this == other); }

private:
  // Numbers that are not finite count by their bits too, so that NaN is the same as itself.
  void AddNumber(double number)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, &number, sizeof(word));
    this->words.push_back(word);
  }

  // The length comes first, so that no list continues the one before it.
  template <class List>
  void AddAll(const List& list)
  {
    this->words.push_back(list.size());
    for (const auto& input : list)
    {
      this->Add(input);
    }
  }

  std::vector<std::uint64_t> words;
};

}

#endif
