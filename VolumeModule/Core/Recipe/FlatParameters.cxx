#include "Core/Recipe/FlatParameters.h"

#include "Core/Recipe/ParameterBlock.h"

#include <algorithm>
#include <regex>
#include <set>

namespace varimarch
{

namespace
{

// The file of the vertex shader that passes nothing on; it is replaced if parameters are passed.
constexpr char Passing[] = "PassParameters.glsl";

bool IsBlock(const ShaderFile& file)
{
  return !MembersOf(file.text).empty();
}

std::set<std::string> NamesIn(const std::vector<ShaderFile>& files)
{
  static const std::regex name(R"([A-Za-z_]\w*)");
  std::set<std::string> names;
  for (const ShaderFile& file : files)
  {
    if (!IsBlock(file))
    {
      for (std::sregex_iterator found(file.text.begin(), file.text.end(), name), none;
           found != none; ++found)
      {
        names.insert(found->str());
      }
    }
  }
  return names;
}

// The block members that a shader uses, in the order of its blocks, as long as they fit.
std::vector<BlockMember> PassedMembers(const std::vector<ShaderFile>& files, int mostComponents)
{
  const std::set<std::string> names = NamesIn(files);
  std::vector<BlockMember> passed;
  for (const ShaderFile& file : files)
  {
    for (const BlockMember& member : MembersOf(file.text))
    {
      if (names.count(member.name) > 0 && ComponentsOf(member) <= mostComponents)
      {
        mostComponents -= ComponentsOf(member);
        passed.push_back(member);
      }
    }
  }
  return passed;
}

std::string VariableOf(const BlockMember& member)
{
  return member.name + "Flat";
}

std::string Declaration(const BlockMember& member)
{
  const std::string size = member.count > 1 ? "[" + std::to_string(member.count) + "]" : "";
  return member.type + " " + VariableOf(member) + size + ";\n";
}

std::string VertexText(const std::vector<BlockMember>& members)
{
  std::string declarations;
  std::string assignments;
  for (const BlockMember& member : members)
  {
    declarations += "flat out " + Declaration(member);
    assignments += "  " + VariableOf(member) + " = " + member.name + ";\n";
  }
  return declarations + "\nvoid PassParameters()\n{\n" + assignments + "}\n";
}

// Declares the variables, and macros by which the rest of the shader reads them as members.
std::string FragmentText(const std::vector<BlockMember>& members)
{
  std::string text;
  for (const BlockMember& member : members)
  {
    text +=
      "flat in " + Declaration(member) + "#define " + member.name + " " + VariableOf(member) + "\n";
  }
  return text;
}

}

void HandParametersOn(
  std::vector<ShaderFile>& vertex, std::vector<ShaderFile>& fragment, int mostComponents)
{
  if (VolumeCount(fragment) > 1)
  {
    return;
  }
  const std::vector<BlockMember> members = PassedMembers(fragment, mostComponents);
  for (ShaderFile& file : vertex)
  {
    file = file.path == Passing ? ShaderFile{ "Flat", VertexText(members) } : file;
  }
  const auto lastBlock = std::find_if(fragment.rbegin(), fragment.rend(), IsBlock);
  fragment.insert(lastBlock.base(), { "Flat", FragmentText(members) });
}

}
