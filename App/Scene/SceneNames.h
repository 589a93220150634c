#ifndef Varimarch_Scene_SceneNames_h
#define Varimarch_Scene_SceneNames_h

#include "Scene/Scene.h"

#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

/// The words that files and the command line use for the choices of a scene, in the order in
/// which they are offered.
template <class Value>
using NameTable = std::vector<std::pair<std::string, Value>>;

const NameTable<View>& ViewNames();
const NameTable<Blend>& BlendNames();
const NameTable<Acceleration>& AccelerationNames();
const NameTable<Integration>& IntegrationNames();
const NameTable<Domain>& DomainNames();

const NameTable<ProceduralKind>& ProceduralNames();
const NameTable<SlabBlend>& SlabBlendNames();
const NameTable<bool>& ProjectionNames(); ///< true is parallel
const NameTable<bool>& ByteOrderNames();  ///< true is big-endian

const NameTable<MapperKind>& MapperKindNames();

/// Types of a raw file's voxels: "uint8", "int16", ..., with VTK's number for each.
const NameTable<int>& RawTypeNames();

template <class Value>
std::vector<std::string> NamesOf(const NameTable<Value>& table)
{
  std::vector<std::string> names;
  for (const auto& row : table)
  {
    names.push_back(row.first);
  }
  return names;
}

/// The value of a word; the word must be in the table.
template <class Value>
Value ValueOf(const NameTable<Value>& table, const std::string& name)
{
  std::size_t i = 0;
  while (table[i].first != name)
  {
    ++i;
  }
  return table[i].second;
}

/// The word for a value; the value must be in the table.
template <class Value>
const std::string& NameOf(const NameTable<Value>& table, Value value)
{
  std::size_t i = 0;
  while (table[i].second != value)
  {
    ++i;
  }
  return table[i].first;
}

/// `did you mean "anterior"?` for the nearest of the known names, or, where none is near,
/// `known: anterior, posterior, ...`.
std::string Suggestion(const std::string& name, const std::vector<std::string>& known);

}

#endif
