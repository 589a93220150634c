#include "March/Device/RayMarchProgram.h"

#include "Core/Recipe/FlatUniforms.h"
#include "Core/Recipe/ShaderAssembly.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/Device/ShaderFiles.h"
#include "March/Processor/SoftwareRasterizer.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLUniforms.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Empty when the source compiles. Asked before VTK's shader cache is, which would print the whole
// source with its own line numbers.
std::string CompilerMessages(
  vtkShader::Type type, const std::string& source, const std::vector<ShaderFile>& files)
{
  vtkNew<vtkShader> shader;
  shader->SetType(type);
  shader->SetSource(source);
  const bool compiles = shader->Compile();
  const std::string messages = shader->GetError();
  shader->Cleanup();
  return compiles ? "" : TraceShaderErrors(messages, files);
}

// The files, with a user's text in place of those slots that it is for.
std::vector<ShaderFile> WithUserCode(
  std::vector<ShaderFile> files, const std::vector<std::string>& parts, const UserShaderCode& code)
{
  for (const auto& [slot, text] : code.textOfSlot)
  {
    const auto isOfSlot = [&, prefix = slot + "/"](const ShaderFile& file)
    { return file.path.compare(0, prefix.size(), prefix) == 0; };
    const auto file = std::find_if(files.begin(), files.end(), isOfSlot);
    if (file == files.end())
    {
      std::string known;
      for (const std::string& part : parts)
      {
        known += " " + part;
      }
      throw std::runtime_error(
        "The shader of this picture has no slot " + slot + " to be replaced: it has" + known);
    }
    *file = { "//Varimarch::" + slot, text };
  }
  if (!code.uniforms.empty())
  {
    files.insert(files.begin() + 1, { "custom uniforms", code.uniforms });
  }
  return files;
}

// The position takes four.
int MostFlatComponents()
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &most);
  return std::max(most - 4, 0);
}

// Which of two outputs is the first is for the linker to say, unless it is told.
void OrderOutputs(vtkShaderProgram* program)
{
  const auto handle = GLuint(program->GetHandle());
  if (glGetFragDataLocation(handle, "fragOutput1") != 0 &&
    glGetFragDataLocation(handle, "fragOutput0") == 0)
  {
    return;
  }
  glBindFragDataLocation(handle, 0, "fragOutput0");
  glBindFragDataLocation(handle, 1, "fragOutput1");
  glLinkProgram(handle);
  glUseProgram(handle);
}

}

RayMarchProgram::Sources RayMarchProgram::Assemble(
  const std::vector<std::string>& parts, const UserShaderCode& userCode)
{
  std::vector<ShaderFile> vertex = LoadShaderFiles({ VertexShaderPart() });
  std::vector<ShaderFile> fragment = WithUserCode(LoadShaderFiles(parts), parts, userCode);
  // Graphics cards keep uniforms where every pixel has them for nothing.
  if (IsSoftwareRasterizer())
  {
    HandUniformsOn(vertex, fragment, MostFlatComponents());
  }
  Sources sources{ AssembleShader(vertex), AssembleShader(fragment), "" };
  sources.failure = CompilerMessages(vtkShader::Vertex, sources.vertex, vertex) +
    CompilerMessages(vtkShader::Fragment, sources.fragment, fragment);
  return sources;
}

bool RayMarchProgram::Use(
  vtkOpenGLRenderWindow* window, const RenderSettings& settings, const UserShaderCode& userCode)
{
  this->parts = FragmentShaderParts(settings);
  // A shader without a march has none of the slots that a user replaces.
  const UserShaderCode& used = Marches(settings) ? userCode : UserShaderCode();
  std::vector<std::string> key = this->parts;
  key.push_back(used.uniforms);
  for (const auto& [slot, text] : used.textOfSlot)
  {
    key.insert(key.end(), { slot, text });
  }
  const bool isNew = this->sourcesOfParts.count(key) == 0;
  if (isNew)
  {
    this->sourcesOfParts[key] = Assemble(this->parts, used);
  }
  // A shader that has failed is not tried again with every frame.
  Sources& sources = this->sourcesOfParts[key];
  if (sources.failure.empty())
  {
    this->program = window->GetShaderCache()->ReadyShaderProgram(
      sources.vertex.c_str(), sources.fragment.c_str(), "");
    sources.failure = this->program ? "" : "it compiles but does not link";
  }
  if (!sources.failure.empty())
  {
    throw std::runtime_error("Cannot compile the ray march shader: " + sources.failure);
  }
  OrderOutputs(this->program);
  return isNew;
}

void RayMarchProgram::SetUniformsOf(vtkVolume* volume)
{
  auto* uniforms =
    vtkOpenGLUniforms::SafeDownCast(volume->GetShaderProperty()->GetFragmentCustomUniforms());
  if (uniforms)
  {
    uniforms->SetUniforms(this->program);
  }
  volume->GetMapper()->InvokeEvent(vtkCommand::UpdateShaderEvent, this->program);
}

void RayMarchProgram::Share(const RayMarchProgram& whole, std::size_t newVolume)
{
  this->program = whole.program;
  this->volume = newVolume;
}

std::string RayMarchProgram::NameOf(const char* name) const
{
  return this->volume ? NameOfVolume(name, *this->volume) : name;
}

void RayMarchProgram::Forget()
{
  this->program = nullptr;
  this->parts.clear();
  this->sourcesOfParts.clear();
}

void RayMarchProgram::Set(const char* name, int value)
{
  this->program->SetUniformi(this->NameOf(name).c_str(), value);
}

void RayMarchProgram::Set(const char* name, double value)
{
  this->program->SetUniformf(this->NameOf(name).c_str(), float(value));
}

void RayMarchProgram::Set(const char* name, glm::ivec2 value)
{
  this->program->SetUniform2i(this->NameOf(name).c_str(), glm::value_ptr(value));
}

void RayMarchProgram::Set(const char* name, glm::dvec2 value)
{
  this->program->SetUniform2f(this->NameOf(name).c_str(), glm::value_ptr(glm::vec2(value)));
}

void RayMarchProgram::Set(const char* name, glm::dvec3 value)
{
  this->program->SetUniform3f(this->NameOf(name).c_str(), glm::value_ptr(glm::vec3(value)));
}

void RayMarchProgram::Set(const char* name, glm::dvec4 value)
{
  this->program->SetUniform4f(this->NameOf(name).c_str(), glm::value_ptr(glm::vec4(value)));
}

void RayMarchProgram::Set(const char* name, const glm::dmat3& value)
{
  glm::mat3 rounded(value);
  this->program->SetUniformMatrix3x3(this->NameOf(name).c_str(), glm::value_ptr(rounded));
}

void RayMarchProgram::Set(const char* name, const glm::dmat4& value)
{
  glm::mat4 rounded(value);
  this->program->SetUniformMatrix4x4(this->NameOf(name).c_str(), glm::value_ptr(rounded));
}

void RayMarchProgram::Set(const char* name, vtkTextureObject* activeTexture)
{
  this->program->SetUniformi(this->NameOf(name).c_str(), activeTexture->GetTextureUnit());
}

}
