#include "ArgumentChecks.h"

#include "Scene/SceneNames.h"

#include <algorithm>

namespace varimarch
{

std::string NameProblem(const std::string& text, const std::vector<std::string>& names)
{
  const bool known = std::find(names.begin(), names.end(), text) != names.end();
  return known ? std::string() : "unknown name \"" + text + "\"; " + Suggestion(text, names);
}

}
