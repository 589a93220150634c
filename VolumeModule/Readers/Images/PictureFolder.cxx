#include "Readers/Images/PictureFolder.h"

#include "Readers/FileContent.h"
#include "Readers/Formats.h"
#include "Readers/HeaderText.h"
#include "Readers/NumberText.h"
#include "Readers/Signatures.h"

#include <vtkNew.h>
#include <vtkSortFileNames.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

/// A name with the last whole number in it.
struct NumberedName
{
  std::string path;
  std::string before; ///< the text before the number and its sign
  std::string behind;
  double number = 0.0;
  bool hasHyphen = false; ///< true if a hyphen stands before the number
};

std::optional<NumberedName> NumberOf(const std::string& path)
{
  constexpr std::size_t MostDigits = 15;
  const std::string name = fs::path(path).filename().string();
  const auto isDigit = [&](std::size_t place)
  { return std::isdigit(static_cast<unsigned char>(name[place])) != 0; };
  std::size_t end = name.rfind('.') == std::string::npos ? name.size() : name.rfind('.');
  while (end > 0 && !isDigit(end - 1))
  {
    --end;
  }
  std::size_t begin = end;
  while (begin > 0 && isDigit(begin - 1))
  {
    --begin;
  }
  if (begin == end || end - begin > MostDigits)
  {
    return std::nullopt;
  }
  NumberedName numbered = { path, name.substr(0, begin), name.substr(end),
    std::stod(name.substr(begin, end - begin)), begin > 0 && name[begin - 1] == '-' };
  if (numbered.hasHyphen)
  {
    numbered.before.pop_back();
    numbered.number = -numbered.number;
  }
  return numbered;
}

/// The paths in order of signed numbers; nothing unless hyphens are signs, because some of the
/// names, which are otherwise the same, have one and others have none.
std::optional<std::vector<std::string>> InSignedOrder(const std::vector<std::string>& paths)
{
  std::vector<NumberedName> names;
  bool hasHyphens[2] = {};
  for (const std::string& path : paths)
  {
    const std::optional<NumberedName> name = NumberOf(path);
    if (!name ||
      (!names.empty() &&
        (name->before != names.front().before || name->behind != names.front().behind)))
    {
      return std::nullopt;
    }
    hasHyphens[name->hasHyphen ? 1 : 0] = true;
    names.push_back(*name);
  }
  if (!hasHyphens[0] || !hasHyphens[1])
  {
    return std::nullopt;
  }
  std::sort(names.begin(), names.end(),
    [](const NumberedName& one, const NumberedName& other) { return one.number < other.number; });
  std::vector<std::string> sorted;
  for (const NumberedName& name : names)
  {
    sorted.push_back(name.path);
  }
  return sorted;
}

std::vector<std::string> InNaturalOrder(const std::vector<std::string>& paths)
{
  vtkNew<vtkStringArray> names;
  for (const std::string& path : paths)
  {
    names->InsertNextValue(path);
  }
  vtkNew<vtkSortFileNames> sort;
  sort->NumericSortOn();
  sort->IgnoreCaseOn();
  sort->SetInputFileNames(names);
  sort->Update();
  std::vector<std::string> sorted;
  for (vtkIdType i = 0; i < sort->GetFileNames()->GetNumberOfValues(); ++i)
  {
    sorted.push_back(sort->GetFileNames()->GetValue(i));
  }
  return sorted;
}

/// Takes the preview of a SkyScan reconstruction out of the paths.
/// @returns its name, or an empty one
std::string TakenPreview(std::vector<std::string>& paths)
{
  constexpr const char* Mark = "_spr";
  const auto preview = std::find_if(paths.begin(), paths.end(),
    [&](const std::string& path)
    {
      const std::string stem = LowerCase(fs::path(path).stem().string());
      const std::size_t place = stem.rfind(Mark);
      return place != std::string::npos && place + std::string(Mark).size() == stem.size();
    });
  if (preview == paths.end() || paths.size() < 2)
  {
    return "";
  }
  const std::string name = fs::path(*preview).filename().string();
  paths.erase(preview);
  return name;
}

/// The size of a voxel in the log of a reconstruction, the last that it states [mm]; 0 if none.
double VoxelMmOf(const std::string& logPath)
{
  constexpr const char* Key = "pixel size (um)";
  constexpr double MmPerMicrometre = 1e-3;
  double voxelMm = 0.0;
  HeaderLines lines(logPath);
  while (const std::optional<std::string> line = lines.Next())
  {
    const std::size_t equals = line->find('=');
    const bool isSize =
      equals != std::string::npos && LowerCase(Trimmed(line->substr(0, equals))) == Key;
    const double size = isSize ? NumberIn(Trimmed(line->substr(equals + 1))).value_or(0.0) : 0.0;
    voxelMm = size > 0.0 ? size * MmPerMicrometre : voxelMm;
  }
  return voxelMm;
}

}

PictureFolder PictureFolderAt(const std::string& folder)
{
  PictureFolder found;
  std::set<std::string> logs;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (!entry.is_regular_file())
    {
      continue;
    }
    if (LowerCase(entry.path().extension().string()) == ".log")
    {
      logs.insert(entry.path().string());
    }
    else if (IsStackSlice(FirstBytes(entry.path())))
    {
      found.slices.push_back(entry.path().string());
    }
  }
  found.preview = TakenPreview(found.slices);
  found.slices = InSignedOrder(found.slices).value_or(InNaturalOrder(found.slices));
  for (const std::string& log : logs)
  {
    const double voxelMm = VoxelMmOf(log);
    found.voxelMm = voxelMm > 0.0 ? voxelMm : found.voxelMm;
  }
  return found;
}

}
