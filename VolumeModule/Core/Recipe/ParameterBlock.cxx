#include "Core/Recipe/ParameterBlock.h"

#include <regex>

namespace varimarch
{

std::vector<BlockMember> MembersOf(const std::string& text)
{
  static const std::regex block(R"(layout\(std140\) uniform \w+\s*\{([^}]*)\};)");
  static const std::regex declaration(R"(\n\s*(\w+) (\w+)(?:\[(\d+)\])?;)");
  std::vector<BlockMember> members;
  std::smatch found;
  if (!std::regex_search(text, found, block))
  {
    return members;
  }
  const std::string body = found[1];
  for (std::sregex_iterator member(body.begin(), body.end(), declaration), none; member != none;
       ++member)
  {
    const int count = (*member)[3].matched ? std::stoi((*member)[3]) : 1;
    members.push_back({ (*member)[1], (*member)[2], count });
  }
  return members;
}

int ComponentsOf(const BlockMember& member)
{
  const int side = member.type.back() - '0';
  const bool isScalar = member.type == "float" || member.type == "int";
  const int ofOne = isScalar ? 1 : member.type[0] == 'm' ? side * side : side;
  return ofOne * member.count;
}

std::vector<std::string> SamplersOf(const std::string& text)
{
  static const std::regex declaration(R"(uniform sampler\w+ (\w+);)");
  std::vector<std::string> names;
  for (std::sregex_iterator sampler(text.begin(), text.end(), declaration), none; sampler != none;
       ++sampler)
  {
    names.push_back((*sampler)[1]);
  }
  return names;
}

}
