#include "Fuzz/FuzzTarget.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

std::vector<FuzzTarget> FuzzTargets()
{
  std::vector<FuzzTarget> targets = VolumeTargets();
  for (const std::vector<FuzzTarget>& more :
    { DicomTargets(), LookTargets(), SceneTargets(), ArchiveTargets(),
      std::vector<FuzzTarget>{ RemoteTarget(), RawGuessTarget(), TransferFunctionTarget(),
        FieldTarget(), PacketTarget(), RecipeTarget() } })
  {
    targets.insert(targets.end(), more.begin(), more.end());
  }
  return targets;
}

FuzzTarget FuzzTargetNamed(const std::string& name)
{
  const std::vector<FuzzTarget> targets = FuzzTargets();
  const auto target = std::find_if(targets.begin(), targets.end(),
    [&](const FuzzTarget& candidate) { return candidate.name == name; });
  if (target == targets.end())
  {
    std::string names;
    for (const FuzzTarget& known : targets)
    {
      names += " " + known.name;
    }
    throw std::invalid_argument("expected the name of a target:" + names + "; found " + name);
  }
  return *target;
}

void Require(bool holds, const std::string& property)
{
  if (!holds)
  {
    throw std::logic_error(property);
  }
}

void RequireOneLine(const std::string& message)
{
  Require(!message.empty() && message.find('\n') == std::string::npos,
    "an error's message is not one line: " + message);
}

}
