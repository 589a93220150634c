#ifndef Varimarch_Readers_Pyramids_Json_h
#define Varimarch_Readers_Pyramids_Json_h

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The object in a file of JSON.
/// @throws std::runtime_error if the file cannot be read, or holds anything else
nlohmann::json JsonObjectOf(const std::string& path);

/// The value of a key; null if there is none, or the value is no object.
const nlohmann::json& ValueAt(const nlohmann::json& object, const char* key);

/// A text; empty if the value is none.
std::string TextIn(const nlohmann::json& value);

/// The elements of a value; none if it is no list.
std::vector<nlohmann::json> ListIn(const nlohmann::json& value);

/// A list of numbers; empty if the value is anything else.
std::vector<double> NumbersIn(const nlohmann::json& value);

}

#endif
