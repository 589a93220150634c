// C++ and OpenGL agree on the layout of the parameters of a march.

#include "Core/Parameters/MarchParameters.h"
#include "Core/Recipe/ShaderAssembly.h"
#include "VtkVersions.h"

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

using namespace varimarch;

namespace
{

std::string TextOf(const std::string& path)
{
  std::ifstream stream(std::string(SHADER_FOLDER) + "/" + path);
  EXPECT_TRUE(stream) << path;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

struct TypeLayout
{
  std::size_t size;
  std::size_t alignment;
};

template <class Type>
TypeLayout LayoutOf()
{
  return { sizeof(Type), alignof(Type) };
}

const std::map<std::string, TypeLayout> layouts = {
  { "float", LayoutOf<float>() },
  { "int", LayoutOf<int>() },
  { "vec2", LayoutOf<shader::vec2>() },
  { "ivec2", LayoutOf<shader::ivec2>() },
  { "vec3", LayoutOf<shader::vec3>() },
  { "vec4", LayoutOf<shader::vec4>() },
  { "mat3", LayoutOf<shader::mat3>() },
  { "mat4", LayoutOf<shader::mat4>() },
};

// Offset of each member in C++, and the total size.
struct StructLayout
{
  std::map<std::string, std::size_t> offsets;
  std::size_t size = 0;
};

StructLayout StructOf(const std::vector<BlockMember>& members)
{
  StructLayout found;
  for (const BlockMember& member : members)
  {
    const TypeLayout& type = layouts.at(member.type);
    found.size = (found.size + type.alignment - 1) / type.alignment * type.alignment;
    found.offsets[member.name] = found.size;
    found.size += member.count * type.size;
  }
  found.size = (found.size + 15) / 16 * 16;
  return found;
}

// Offset of a member in the block of a program; -1 if it is missing.
GLint OffsetInBlock(GLuint program, const BlockMember& member)
{
  const std::string name = member.name + (member.count > 1 ? "[0]" : "");
  const char* const names[] = { name.c_str() };
  GLuint index = GL_INVALID_INDEX;
  glGetUniformIndices(program, 1, names, &index);
  GLint offset = -1;
  if (index != GL_INVALID_INDEX)
  {
    glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &offset);
  }
  return offset;
}

// A program that reads one number of the block.
GLuint ProgramOf(const std::string& block, const std::string& number)
{
  const auto compiled = [](GLenum type, const std::string& text)
  {
    const GLuint stage = glCreateShader(type);
    const std::string whole = "#version 150\n" + text;
    const char* const source = whole.c_str();
    glShaderSource(stage, 1, &source, nullptr);
    glCompileShader(stage);
    return stage;
  };
  const GLuint program = glCreateProgram();
  glAttachShader(program,
    compiled(GL_VERTEX_SHADER, block + "void main() { gl_Position = vec4(" + number + "); }\n"));
  glAttachShader(
    program, compiled(GL_FRAGMENT_SHADER, "out vec4 color;\nvoid main() { color = vec4(1.0); }\n"));
  glLinkProgram(program);
  return program;
}

void ExpectSameLayout(const std::string& path, std::size_t size, const std::string& number)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(8, 8);
  window->Render();
  const std::vector<BlockMember> members = MembersOf(TextOf(path));
  const StructLayout layout = StructOf(members);
  EXPECT_EQ(layout.size, size);
  const GLuint program = ProgramOf(TextOf(path), number);
  for (const BlockMember& member : members)
  {
    EXPECT_EQ(OffsetInBlock(program, member), GLint(layout.offsets.at(member.name)))
      << path << ": " << member.name;
  }
  glDeleteProgram(program);
}

}

TEST(ParameterBlocks, OfRaysLieInMemoryAsOnTheDevice)
{
  ExpectSameLayout("RayParameters.glsl", sizeof(RayParameters), "stepMm");
}

TEST(ParameterBlocks, OfVolumesLieInMemoryAsOnTheDevice)
{
  ExpectSameLayout("VolumeParameters.glsl", sizeof(VolumeParameters), "cellsPerBrick");
}
