#include "ArgumentChecks.h"

#include "Scene/Json/SceneNames.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

std::string NameProblem(const std::string& text, const std::vector<std::string>& names)
{
  const bool known = std::find(names.begin(), names.end(), text) != names.end();
  return known ? std::string() : "unknown name \"" + text + "\"; " + Suggestion(text, names);
}

void CheckMayReplace(const std::string& path, bool overwrites)
{
  if (!overwrites && std::filesystem::exists(path))
  {
    throw std::runtime_error(path + ": exists already; --overwrite replaces it");
  }
}

}
