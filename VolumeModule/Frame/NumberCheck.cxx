#include "Frame/NumberCheck.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace varimarch
{

namespace
{

std::string ExpectedBy(const NumberSetting& setting)
{
  const bool hasLeast = setting.least > -LargestSetting;
  const bool hasMost = setting.most < LargestSetting;
  if (hasLeast && hasMost)
  {
    return "one from " + TextOf(setting.least) + " to " + TextOf(setting.most);
  }
  return hasLeast ? "a finite one, at least " + TextOf(setting.least) : "a finite one";
}

}

double NumberCheck::Usable(const NumberSetting& setting, double found)
{
  const double usable =
    std::isnan(found) ? setting.usual : std::clamp(found, setting.least, setting.most);
  if (usable != found)
  {
    this->Note("Cannot use the number " + TextOf(found) + " of " + setting.setter + ": expected " +
      ExpectedBy(setting) + ". " + TextOf(usable) + " is used instead; set another number.");
  }
  return usable;
}

glm::dvec3 NumberCheck::Usable(const NumberSetting& setting, const double* found)
{
  return { this->Usable(setting, found[0]), this->Usable(setting, found[1]),
    this->Usable(setting, found[2]) };
}

void NumberCheck::Note(const std::string& sentence)
{
  if (std::find(this->notes.begin(), this->notes.end(), sentence) == this->notes.end())
  {
    this->notes.push_back(sentence);
  }
}

std::string Joined(const std::vector<std::string>& sentences)
{
  std::string all;
  for (const std::string& sentence : sentences)
  {
    all += sentence + " ";
  }
  return all;
}

std::string TextOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string TextOf(const glm::dvec3& numbers)
{
  return "(" + TextOf(numbers.x) + ", " + TextOf(numbers.y) + ", " + TextOf(numbers.z) + ")";
}

}
