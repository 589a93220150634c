#include "Validators.h"

#include "Scene/SceneNames.h"

#include <algorithm>
#include <limits>

namespace varimarch
{

CLI::Validator Above(double limit)
{
  const auto check = [limit](std::string& text)
  {
    double number = 0.0;
    const bool good = CLI::detail::lexical_cast(text, number) && number > limit &&
      number < std::numeric_limits<double>::infinity();
    return good
      ? std::string()
      : "expected a number > " + CLI::detail::to_string(limit) + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

CLI::Validator NameValidator(const std::vector<std::string>& names)
{
  const auto check = [names](std::string& text)
  {
    const bool known = std::find(names.begin(), names.end(), text) != names.end();
    return known ? std::string() : "unknown name \"" + text + "\"; " + Suggestion(text, names);
  };
  return CLI::Validator(check, CLI::detail::join(names, "|"));
}

}
