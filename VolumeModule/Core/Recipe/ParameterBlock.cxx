#include "Core/Recipe/ParameterBlock.h"

#include <regex>

namespace varimarch
{

namespace
{

// The text between the braces of the uniform block; empty without a block. std::regex calls itself
// for each character that a repetition matches, so that a long body must not be matched by one.
std::string BodyOfBlock(const std::string& text)
{
  static const std::regex head(R"(layout\(std140\) uniform \w+\s*\{)");
  std::smatch found;
  if (!std::regex_search(text, found, head))
  {
    return {};
  }
  const std::size_t begin = std::size_t(found.position() + found.length());
  const std::size_t end = text.find("};", begin);
  return end == std::string::npos ? std::string() : text.substr(begin, end - begin);
}

}

std::vector<BlockMember> MembersOf(const std::string& text)
{
  static const std::regex declaration(R"(\n\s*(\w+) (\w+)(?:\[(\d+)\])?;)");
  std::vector<BlockMember> members;
  const std::string body = BodyOfBlock(text);
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
