#include "Core/Recipe/ShaderAssembly.h"

#include "Core/Recipe/ParameterBlock.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace varimarch
{

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

}
