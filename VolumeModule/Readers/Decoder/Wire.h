#ifndef Varimarch_Readers_Decoder_Wire_h
#define Varimarch_Readers_Decoder_Wire_h

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Values as bytes, for messages between two processes of one build. A struct takes part by a
// function Fields(wire, value) that passes its members to the wire; both directions use it.

namespace varimarch
{

/// Appends values to bytes.
class WireWriter
{
public:
  template <class... Values>
  void operator()(const Values&... values)
  {
    (this->Put(values), ...);
  }

  const std::string& Bytes() const { return this->bytes; }

private:
  template <class Value>
  void Put(const Value& value)
  {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
    {
      this->bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    else
    {
      Fields(*this, const_cast<Value&>(value)); // reads only
    }
  }

  void Put(const std::string& text)
  {
    this->Put(std::uint64_t(text.size()));
    this->bytes += text;
  }

  template <class Value>
  void Put(const std::vector<Value>& values)
  {
    this->Put(std::uint64_t(values.size()));
    for (const Value& value : values)
    {
      this->Put(value);
    }
  }

  template <class Value, std::size_t Count>
  void Put(const std::array<Value, Count>& values)
  {
    for (const Value& value : values)
    {
      this->Put(value);
    }
  }

  template <class Value>
  void Put(const std::optional<Value>& value)
  {
    this->Put(value.has_value());
    if (value)
    {
      this->Put(*value);
    }
  }

  std::string bytes;
};

/// Takes values from bytes that may be anything: their writer has perhaps read a forged file.
class WireReader
{
public:
  explicit WireReader(const std::string& bytes)
    : bytes(bytes)
  {
  }

  /// @throws std::runtime_error if the bytes end early
  template <class... Values>
  void operator()(Values&... values)
  {
    (this->Take(values), ...);
  }

private:
  template <class Value>
  void Take(Value& value)
  {
    if constexpr (std::is_same_v<Value, bool>)
    {
      value = *this->Next(1) != 0;
    }
    else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
    {
      std::memcpy(&value, this->Next(sizeof(value)), sizeof(value));
    }
    else
    {
      Fields(*this, value);
    }
  }

  void Take(std::string& text)
  {
    const std::size_t length = this->Count();
    text.assign(this->Next(length), length);
  }

  template <class Value>
  void Take(std::vector<Value>& values)
  {
    const std::size_t count = this->Count();
    values.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
      values.emplace_back();
      this->Take(values.back());
    }
  }

  template <class Value, std::size_t Count>
  void Take(std::array<Value, Count>& values)
  {
    for (Value& value : values)
    {
      this->Take(value);
    }
  }

  template <class Value>
  void Take(std::optional<Value>& value)
  {
    bool isSet = false;
    this->Take(isSet);
    value.reset();
    if (isSet)
    {
      this->Take(value.emplace());
    }
  }

  /// A number of values; each takes a byte at least.
  std::size_t Count()
  {
    std::uint64_t count = 0;
    this->Take(count);
    this->Check(count);
    return std::size_t(count);
  }

  const char* Next(std::size_t count)
  {
    this->Check(count);
    const char* const begin = this->bytes.data() + this->place;
    this->place += count;
    return begin;
  }

  void Check(std::uint64_t count) const
  {
    if (count > this->bytes.size() - this->place)
    {
      throw std::runtime_error("a message ends early");
    }
  }

  const std::string& bytes;
  std::size_t place = 0;
};

/// The bytes of values.
template <class... Values>
std::string Packed(const Values&... values)
{
  WireWriter wire;
  wire(values...);
  return wire.Bytes();
}

}

#endif
