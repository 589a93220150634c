#include "Core/UniformsReadOnce.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <sstream>

namespace varimarch
{

namespace
{

// The line of RayMarch.frag.glsl in whose place uniforms are read.
constexpr char Place[] = "  // Uniforms read once are read here.";

using TypeOfUniform = std::map<std::string, std::string>;

// Arrays and samplers are left where they are.
const std::regex& Declaration()
{
  static const std::regex declaration(R"(^uniform (float|int|ivec\d|vec\d|mat\d) (\w+);)");
  return declaration;
}

std::string VariableOf(const std::string& uniform)
{
  return uniform + "Once";
}

TypeOfUniform UniformsOf(const std::vector<ShaderFile>& files)
{
  TypeOfUniform uniforms;
  for (const ShaderFile& file : files)
  {
    std::istringstream lines(file.text);
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
    {
      if (std::regex_search(line, match, Declaration()))
      {
        uniforms[match[2]] = match[1];
      }
    }
  }
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

std::string Readings(const TypeOfUniform& uniforms)
{
  std::string text;
  for (const auto& [name, type] : uniforms)
  {
    const bool isInteger = type[0] == 'i';
    text += " " + VariableOf(name) + " = " + name + (isInteger ? " * int(unity);" : " * unity;");
  }
  return text;
}

std::string Changed(const std::string& text, const TypeOfUniform& uniforms)
{
  std::istringstream lines(text);
  std::string changed;
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
  {
    if (std::regex_search(line, match, Declaration()))
    {
      const std::string variable = match[1].str() + " " + VariableOf(match[2]) + ";";
      changed += match.str() + " " + variable + match.suffix().str();
    }
    else
    {
      changed += line == Place ? Readings(uniforms) : WithVariables(line, uniforms);
    }
    changed += "\n";
  }
  return changed;
}

}

std::vector<ShaderFile> WithUniformsReadOnce(std::vector<ShaderFile> files, const ShaderFile& unity)
{
  const auto isVolume = [](const ShaderFile& file) { return file.path == "VolumeSlots.glsl"; };
  const auto hasPlace = [](const ShaderFile& file)
  { return file.text.find(Place) != std::string::npos; };
  if (std::count_if(files.begin(), files.end(), isVolume) > 1 ||
    std::none_of(files.begin(), files.end(), hasPlace))
  {
    return files;
  }
  const TypeOfUniform uniforms = UniformsOf(files);
  for (ShaderFile& file : files)
  {
    file.text = Changed(file.text, uniforms);
  }
  files.insert(files.begin() + 1, unity);
  return files;
}

}
