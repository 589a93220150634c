#include "Core/Recipe/ShaderAssembly.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

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

namespace
{

constexpr std::size_t LinesPerFile = 1000;

// The file with which each volume's part of a shader begins.
constexpr char FirstOfVolume[] = "VolumeParameters.glsl";

// All names that the files of one volume declare, and their text.
struct VolumeText
{
  std::set<std::string> names;
  std::string text;
};

// A line that begins with two words is a declaration.
void AddTo(VolumeText& volume, const std::string& text)
{
  static const std::regex declaration(R"(^(?:uniform |layout\(std140\) |const )?\w+ (\w+))");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::smatch match;
    if (std::regex_search(line, match, declaration))
    {
      volume.names.insert(match[1]);
    }
  }
  for (const BlockMember& member : MembersOf(text))
  {
    volume.names.insert(member.name);
  }
  volume.text += text;
}

std::vector<VolumeText> VolumesOf(const std::vector<ShaderFile>& files)
{
  std::vector<VolumeText> volumes;
  for (const ShaderFile& file : files)
  {
    if (file.path == FirstOfVolume)
    {
      volumes.emplace_back();
    }
    if (!volumes.empty())
    {
      AddTo(volumes.back(), file.text);
    }
  }
  return volumes;
}

// Preprocessor lines that rename what a volume declares, and what it uses of the volume before it.
// The last volume keeps its names.
std::string Renaming(const std::vector<VolumeText>& volumes, std::size_t volume)
{
  std::string text;
  if (volume > 0)
  {
    for (const std::string& name : volumes[volume - 1].names)
    {
      const std::string before = name + "Before";
      if (volumes[volume].text.find(before + "(") != std::string::npos)
      {
        text +=
          "#undef " + before + "\n#define " + before + " " + NameOfVolume(name, volume - 1) + "\n";
      }
      text += "#undef " + name + "\n";
    }
  }
  if (volume + 1 < volumes.size())
  {
    for (const std::string& name : volumes[volume].names)
    {
      text += "#define " + name + " " + NameOfVolume(name, volume) + "\n";
    }
  }
  return text;
}

}

std::size_t VolumeCount(const std::vector<ShaderFile>& files)
{
  return std::size_t(std::count_if(
    files.begin(), files.end(), [](const ShaderFile& file) { return file.path == FirstOfVolume; }));
}

std::string NameOfVolume(const std::string& name, std::size_t volume)
{
  return name + "_" + std::to_string(volume + 1);
}

std::vector<ShaderFile> WithIncludes(const std::vector<ShaderFile>& files,
  const std::function<std::string(const std::string& path)>& read)
{
  static const std::regex include("(^|\n)#include \"([^\"]+)\"[^\n]*");
  std::vector<ShaderFile> included;
  std::vector<ShaderFile> including = files;
  for (ShaderFile& file : including)
  {
    for (std::smatch match; std::regex_search(file.text, match, include);)
    {
      const std::string path = match[2];
      const auto isOfPath = [&](const ShaderFile& other) { return other.path == path; };
      if (std::none_of(included.begin(), included.end(), isOfPath))
      {
        included.push_back({ path, read(path) });
      }
      file.text.erase(std::size_t(match.position()) + std::size_t(match[1].length()),
        std::size_t(match.length() - match[1].length()));
    }
  }
  included.insert(included.end(), including.begin(), including.end());
  return included;
}

std::string AssembleShader(const std::vector<ShaderFile>& files)
{
  const std::vector<VolumeText> volumes = VolumesOf(files);
  std::string source = "#version 150\n";
  std::size_t index = 0;
  std::size_t volume = 0;
  for (const ShaderFile& file : files)
  {
    if (file.path == FirstOfVolume)
    {
      source += Renaming(volumes, volume++);
    }
    // In version 1.50, #line sets the number of its own line; the file begins on the next.
    ++index;
    source += "#line " + std::to_string(LinesPerFile * index) + "\n";
    source += file.text;
    source += "\n";
  }
  return source;
}

std::string TraceShaderErrors(const std::string& messages, const std::vector<ShaderFile>& files)
{
  // Mesa and glslang write 0:line or 0:line(column), NVIDIA writes 0(line).
  static const std::regex position(R"(\b0(?::(\d+)(?:\(\d+\))?|\((\d+)\)))");
  std::string traced;
  auto end = messages.begin();
  for (std::sregex_iterator match(messages.begin(), messages.end(), position), none; match != none;
       ++match)
  {
    const std::size_t line = std::stoul((*match)[1].matched ? (*match)[1] : (*match)[2]);
    const std::size_t index = line / LinesPerFile;
    traced.append(end, (*match)[0].first);
    end = (*match)[0].second;
    traced += index >= 1 && index <= files.size()
      ? files[index - 1].path + ":" + std::to_string(line % LinesPerFile)
      : match->str();
  }
  return traced.append(end, messages.end());
}

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
