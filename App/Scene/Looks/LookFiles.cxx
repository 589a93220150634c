#include "Scene/Looks/LookFiles.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Files/SmallFile.h"
#include "Scene/Json/JsonCursor.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFormats/LookFormats.h"

#include <nlohmann/json.hpp>
#include <vtksys/SystemTools.hxx>

#include <cctype>
#include <filesystem>

namespace varimarch
{

namespace
{

using LookReader = Look (*)(
  const std::string& bytes, const std::string& file, const LookContext& context);
using LookWriter = std::string (*)(const Look& look, const LookContext& context);
using Reader = std::vector<Preset> (*)(
  const std::string& bytes, const std::string& file, const LookContext& context);
using Writer = std::string (*)(const Preset& preset, const LookContext& context);

// Replaces trailing commas by spaces.
std::string WithoutTrailingCommas(std::string text)
{
  bool inString = false;
  std::size_t comma = std::string::npos;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i];
    if (inString)
    {
      i += letter == '\\' ? 1 : 0;
      inString = letter != '"';
    }
    else if ((letter == ']' || letter == '}') && comma != std::string::npos)
    {
      text[comma] = ' ';
      comma = std::string::npos;
    }
    else if (!std::isspace(static_cast<unsigned char>(letter)))
    {
      comma = letter == ',' ? i : std::string::npos;
      inString = letter == '"';
    }
  }
  return text;
}

// Other programs' files hold only the look of a preset.
template <LookReader Read>
std::vector<Preset> OneLook(
  const std::string& bytes, const std::string& file, const LookContext& context)
{
  return { { Read(bytes, file, context) } };
}

std::vector<Preset> ReadSlicerScene(
  const std::string& bytes, const std::string& file, const LookContext& context)
{
  std::vector<Preset> presets;
  for (const Look& look : LooksFromSlicerScene(bytes, file, context))
  {
    presets.push_back({ look });
  }
  return presets;
}

template <LookWriter Write>
std::string WriteLook(const Preset& preset, const LookContext& context)
{
  return Write(preset.look, context);
}

std::vector<Preset> ReadAnyJson(
  const std::string& text, const std::string& file, const LookContext& context)
{
  const nlohmann::json json = ParseJson(WithoutTrailingCommas(text), file);
  if (IsParaViewColorMap(json))
  {
    return { { LookFromParaViewJson(json, file, context) } };
  }
  return { json.contains("volumeProperties") ? Preset{ LookFromSlicerJson(json, file, context) }
                                             : PresetFromJson(JsonCursor(json, file)) };
}

std::string OwnText(const Preset& preset, const LookContext&)
{
  return PresetText(preset);
}

std::string ParaViewText(const Look& look, const LookContext&)
{
  return ParaViewJson(look);
}

struct FormatRow
{
  LookFileFormat format;
  Reader read;
  Writer write; ///< null if the format is read-only
};

// The longest extension that a name ends with decides.
const std::vector<FormatRow>& FormatRows()
{
  static const std::vector<FormatRow> table = {
    { { "Looks", ".json", true }, ReadAnyJson, OwnText },
    { { "3D Slicer volume properties", ".vp.json", true }, ReadAnyJson, WriteLook<SlicerJson> },
    { { "3D Slicer volume properties, old", ".vp", true }, OneLook<LookFromSlicerText>,
      WriteLook<SlicerText> },
    { { "3D Slicer presets", ".xml", false }, ReadSlicerScene, nullptr },
    { { "3D Slicer scenes", ".mrml", false }, ReadSlicerScene, nullptr },
    { { "3D Slicer colour tables", ".ctbl", false }, OneLook<LookFromCtbl>, nullptr },
    { { "ParaView colour maps", ".paraview.json", true }, ReadAnyJson, WriteLook<ParaViewText> },
    { { "MRIcroGL colour tables", ".clut", false }, OneLook<LookFromClut>, nullptr },
    { { "OsiriX and Horos presets", ".plist", false }, OneLook<LookFromPlist>, nullptr },
    { { "Inviwo transfer functions", ".itf", false }, OneLook<LookFromItf>, nullptr },
    { { "Fiji and ImageJ colour tables", ".lut", false }, OneLook<LookFromLut>, nullptr },
    { { "ITK-SNAP label descriptions", ".label", false }, OneLook<LookFromLabelDescriptions>,
      nullptr },
  };
  return table;
}

// Our own format if the name has no known extension.
const FormatRow& RowOf(const std::string& path)
{
  const std::string name =
    vtksys::SystemTools::LowerCase(std::filesystem::path(path).filename().string());
  const FormatRow* best = &FormatRows().front();
  std::size_t length = 0;
  for (const FormatRow& row : FormatRows())
  {
    const std::string& ending = row.format.extension;
    if (vtksys::SystemTools::StringEndsWith(name, ending.c_str()) && ending.size() > length)
    {
      best = &row;
      length = ending.size();
    }
  }
  return *best;
}

}

const std::vector<LookFileFormat>& LookFileFormats()
{
  static const std::vector<LookFileFormat> formats = []
  {
    std::vector<LookFileFormat> list;
    for (const FormatRow& row : FormatRows())
    {
      list.push_back(row.format);
    }
    return list;
  }();
  return formats;
}

std::vector<std::string> WritableLookExtensions()
{
  std::vector<std::string> extensions;
  for (const LookFileFormat& format : LookFileFormats())
  {
    if (format.canBeWritten)
    {
      extensions.push_back(format.extension);
    }
  }
  return extensions;
}

std::vector<Preset> ReadLookFile(const std::string& path, const LookContext& context)
{
  return RowOf(path).read(BytesOfSmallFile(path), path, context);
}

Preset ReadLook(const std::string& path, const std::string& name, const LookContext& context)
{
  const std::vector<Preset> presets = ReadLookFile(path, context);
  if (name.empty() && presets.size() == 1)
  {
    return presets.front();
  }
  std::string names;
  for (const Preset& preset : presets)
  {
    if (preset.look.name == name)
    {
      return preset;
    }
    names += (names.empty() ? "" : ", ") + preset.look.name;
  }
  FailToReadLook(path,
    (name.empty() ? "expected the name of one of its looks"
                  : "expected the look \"" + name + "\"") +
      ", found the looks " + names);
}

void WriteLookFile(const Preset& preset, const std::string& path, const LookContext& context)
{
  const FormatRow& row = RowOf(path);
  if (!row.write)
  {
    throw std::runtime_error("Cannot write " + path + ": " + row.format.description +
      " can only be read; choose a name that ends with one of " +
      vtksys::SystemTools::Join(WritableLookExtensions(), ", ") + ".");
  }
  Preset named = preset;
  named.look.name = NameOfLookFile(path);
  WriteFileWhole(path, row.write(named, context));
}

}
