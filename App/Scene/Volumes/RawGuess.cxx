#include "Scene/Volumes/RawGuess.h"

#include "Scene/Json/SceneNames.h"

#include <vtkDataArray.h>
#include <vtkVolumeFileReader.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <utility>

namespace varimarch
{

namespace
{

constexpr int UsualSides[] = { 512, 256, 1024, 128 };

// Sets the dimensions from a name; returns false if the name contains none.
bool TakeSides(const std::string& name, RawLayout& layout)
{
  std::smatch sides;
  if (!std::regex_search(name, sides, std::regex("(\\d{1,5})x(\\d{1,5})x(\\d{1,5})")))
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    layout.dimensions[axis] = std::max(std::stoi(sides[axis + 1]), 1);
  }
  return true;
}

// Sets the type from a name; returns false if the name contains none.
bool TakeType(const std::string& name, RawLayout& layout)
{
  // "uint16" contains "int16", so the unsigned types come first.
  for (const char* type : { "uint8", "uint16", "uint32", "uint64", "int8", "int16", "int32",
         "int64", "float32", "float64" })
  {
    if (name.find(type) != std::string::npos)
    {
      layout.type = type;
      return true;
    }
  }
  return false;
}

bool IsCube(std::int64_t voxels, RawLayout& layout)
{
  const auto side = std::int64_t(std::llround(std::cbrt(double(voxels))));
  layout.dimensions = { int(side), int(side), int(side) };
  return side > 1 && side * side * side == voxels;
}

bool IsSquareSlices(std::int64_t voxels, RawLayout& layout)
{
  for (const std::int64_t side : UsualSides)
  {
    if (voxels >= side * side && voxels % (side * side) == 0)
    {
      layout.dimensions = { int(side), int(side), int(voxels / (side * side)) };
      return true;
    }
  }
  return false;
}

}

bool IsBareVoxels(const std::string& path)
{
  if (!std::regex_search(path, std::regex("\\.raw(\\.gz)?$", std::regex::icase)))
  {
    return false;
  }
  const char* const format = vtkVolumeFileReader::GetFormatOfFile(path.c_str());
  return !format || format == std::string("raw");
}

RawLayout GuessedRawLayout(const std::string& path, std::int64_t fileBytes)
{
  const std::string name = std::filesystem::path(path).filename().string();
  RawLayout layout;
  const bool hasType = TakeType(name, layout);
  if (TakeSides(name, layout))
  {
    const RawLayout shorts = { layout.dimensions, "int16" };
    layout.type = !hasType && BytesOf(shorts) == fileBytes ? "int16" : layout.type;
    return layout;
  }
  for (const auto& fits : { IsCube, IsSquareSlices })
  {
    for (const char* type : { "uint8", "int16", "float32" })
    {
      RawLayout guess;
      guess.type = hasType ? layout.type : type;
      guess.dimensions = { 1, 1, 1 };
      const std::int64_t voxelBytes = BytesOf(guess);
      if (fileBytes % voxelBytes == 0 && fits(fileBytes / voxelBytes, guess))
      {
        return guess;
      }
    }
  }
  layout.dimensions = { 256, 256, 1 };
  return layout;
}

std::int64_t BytesOf(const RawLayout& layout)
{
  const int voxelBytes = vtkDataArray::GetDataTypeSize(ValueOf(RawTypeNames(), layout.type));
  std::int64_t bytes = voxelBytes;
  for (const int side : layout.dimensions)
  {
    bytes *= side;
  }
  return bytes + layout.headerBytes;
}

}
