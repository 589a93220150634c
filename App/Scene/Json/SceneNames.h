#ifndef Varimarch_Scene_SceneNames_h
#define Varimarch_Scene_SceneNames_h

#include "Core/Fields/VariationField.h"
#include "Scene/Model/Scene.h"

#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

/// Words that files and the command line use for the choices of a scene, in the order in which they
/// are listed.
template <class Value>
using NameTable = std::vector<std::pair<std::string, Value>>;

const NameTable<View>& ViewNames();
const NameTable<Blend>& BlendNames();
const NameTable<Acceleration>& AccelerationNames();
const NameTable<Integration>& IntegrationNames();
const NameTable<VoxelDistance>& VoxelDistanceNames();
const NameTable<Domain>& DomainNames();
const NameTable<Lengths>& LengthsNames();
const NameTable<Interpolation>& InterpolationNames();
const NameTable<VolumeLevel>& LevelNames();
const NameTable<LightKind>& LightKindNames();
const NameTable<RegionShape>& RegionShapeNames();

const NameTable<ProceduralKind>& ProceduralNames();
const NameTable<SlabBlend>& SlabBlendNames();
const NameTable<SliceFusion>& SliceFusionNames();
const NameTable<MeasureKind>& MeasureKindNames();
const NameTable<KeyView>& KeyViewNames();
const NameTable<SliceColors>& SliceColorsNames();
const NameTable<bool>& ProjectionNames(); ///< true: parallel
const NameTable<bool>& ByteOrderNames();  ///< true: big-endian

const NameTable<MapperKind>& MapperKindNames();

/// Voxel types of raw files, "uint8", "int16", ..., with VTK's number of each.
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

/// The value that a word stands for. Requires a word of the table.
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

/// The word for a value. Requires a value of the table.
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

/// `did you mean "anterior"?` with the nearest known name, or `known: anterior, posterior, ...` if
/// none is near.
std::string Suggestion(const std::string& name, const std::vector<std::string>& known);

}

#endif
