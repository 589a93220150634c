#ifndef Varimarch_Readers_Pyramids_XarrayGroup_h
#define Varimarch_Readers_Pyramids_XarrayGroup_h

#include "Readers/Pyramids/ArrayAxes.h"
#include "Readers/Pyramids/Json.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// An array of a group that the Python package xarray wrote, with the places that its coordinates
/// give to its axes. See https://docs.xarray.dev/en/stable/internals/zarr-encoding-spec.html
struct XarrayVariable
{
  std::string folder;
  ArrayAxes axes;
  std::vector<std::string> warnings;
};

/// The names of an array's axes in the attributes that xarray writes; empty texts if it has none.
std::vector<std::string> XarrayNames(const nlohmann::json& attributes, std::size_t rank);

/// The largest array of at least three axes in a group of xarray; nothing if the folder is another
/// one, or is an array itself.
/// @throws std::runtime_error if its coordinates cannot be read
std::optional<XarrayVariable> LargestXarrayVariable(const std::string& folder);

}

#endif
