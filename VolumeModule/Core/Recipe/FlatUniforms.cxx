#include "Core/Recipe/FlatUniforms.h"

#include <limits>
#include <map>
#include <regex>
#include <sstream>

namespace varimarch
{

namespace
{

// The lines of RayMarch.vert.glsl in whose places uniforms are declared and handed on.
constexpr char DeclaringPlace[] = "// Uniforms of the fragment shader are declared here.";
constexpr char HandingPlace[] = "  // And handed on here.";

using TypeOfUniform = std::map<std::string, std::string>;

// Arrays and samplers are left where they are.
const std::regex& Declaration()
{
  static const std::regex declaration(R"(^uniform (float|int|ivec\d|vec\d|mat\d) (\w+);)");
  return declaration;
}

int ComponentsOf(const std::string& type)
{
  const int side = type.back() - '0';
  return type[0] == 'm' ? side * side : type.find("vec") != std::string::npos ? side : 1;
}

std::string VariableOf(const std::string& uniform)
{
  return uniform + "Flat";
}

template <class Work>
void ForEachLine(const std::vector<ShaderFile>& files, Work work)
{
  for (const ShaderFile& file : files)
  {
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);)
    {
      work(line);
    }
  }
}

TypeOfUniform UniformsOf(const std::vector<ShaderFile>& files, int mostComponents)
{
  TypeOfUniform uniforms;
  ForEachLine(files,
    [&](const std::string& line)
    {
      std::smatch match;
      if (std::regex_search(line, match, Declaration()) && ComponentsOf(match[1]) <= mostComponents)
      {
        mostComponents -= ComponentsOf(match[1]);
        uniforms[match[2]] = match[1];
      }
    });
  return uniforms;
}

// The line with variables in place of uniforms. What follows a dot is a member.
std::string WithVariables(const std::string& line, const TypeOfUniform& uniforms)
{
  static const std::regex name(R"(\.?\b[A-Za-z_]\w*)");
  std::string changed;
  auto end = line.begin();
  for (std::sregex_iterator match(line.begin(), line.end(), name), none; match != none; ++match)
  {
    changed.append(end, (*match)[0].first);
    end = (*match)[0].second;
    changed += uniforms.count(match->str()) > 0 ? VariableOf(match->str()) : match->str();
  }
  return changed.append(end, line.end());
}

std::string FragmentLine(const std::string& line, const TypeOfUniform& uniforms)
{
  std::smatch match;
  return std::regex_search(line, match, Declaration()) && uniforms.count(match[2]) > 0
    ? "flat in " + match[1].str() + " " + VariableOf(match[2]) + ";" + match.suffix().str()
    : WithVariables(line, uniforms);
}

// @param own  what the vertex shader declares itself
std::string VertexLine(
  const std::string& line, const TypeOfUniform& uniforms, const TypeOfUniform& own)
{
  std::string text;
  for (const auto& [name, type] : uniforms)
  {
    if (line == DeclaringPlace)
    {
      text += own.count(name) > 0 ? "" : "uniform " + type + " " + name + "; ";
      text += "flat out " + type + " " + VariableOf(name) + "; ";
    }
    else if (line == HandingPlace)
    {
      text += VariableOf(name) + " = " + name + "; ";
    }
  }
  return text.empty() ? line : text;
}

template <class Change>
void ChangeLines(std::vector<ShaderFile>& files, Change change)
{
  for (ShaderFile& file : files)
  {
    std::string text;
    ForEachLine({ file }, [&](const std::string& line) { text += change(line) + "\n"; });
    file.text = text;
  }
}

}

void HandUniformsOn(
  std::vector<ShaderFile>& vertex, std::vector<ShaderFile>& fragment, int mostComponents)
{
  if (VolumeCount(fragment) > 1)
  {
    return;
  }
  const TypeOfUniform uniforms = UniformsOf(fragment, mostComponents);
  const TypeOfUniform own = UniformsOf(vertex, std::numeric_limits<int>::max());
  ChangeLines(fragment, [&](const std::string& line) { return FragmentLine(line, uniforms); });
  ChangeLines(vertex, [&](const std::string& line) { return VertexLine(line, uniforms, own); });
}

}
