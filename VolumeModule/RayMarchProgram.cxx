#include "RayMarchProgram.h"

#include "Core/ShaderAssembly.h"
#include "Core/ShaderRecipe.h"
#include "ShaderFiles.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/type_ptr.hpp>

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

}

RayMarchProgram::Sources RayMarchProgram::Assemble(const std::vector<std::string>& parts)
{
  const std::vector<ShaderFile> vertex = LoadShaderFiles({ VertexShaderPart() });
  const std::vector<ShaderFile> fragment = LoadShaderFiles(parts);
  Sources sources{ AssembleShader(vertex), AssembleShader(fragment), "" };
  sources.failure = CompilerMessages(vtkShader::Vertex, sources.vertex, vertex) +
    CompilerMessages(vtkShader::Fragment, sources.fragment, fragment);
  return sources;
}

bool RayMarchProgram::Use(vtkOpenGLRenderWindow* window, const RenderSettings& settings)
{
  this->parts = FragmentShaderParts(settings);
  const bool isNew = this->sourcesOfParts.count(this->parts) == 0;
  if (isNew)
  {
    this->sourcesOfParts[this->parts] = Assemble(this->parts);
  }
  // A shader that has failed is not tried again with every frame.
  Sources& sources = this->sourcesOfParts[this->parts];
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
  return isNew;
}

void RayMarchProgram::Forget()
{
  this->program = nullptr;
  this->parts.clear();
  this->sourcesOfParts.clear();
}

void RayMarchProgram::Set(const char* name, int value)
{
  this->program->SetUniformi(name, value);
}

void RayMarchProgram::Set(const char* name, double value)
{
  this->program->SetUniformf(name, float(value));
}

void RayMarchProgram::Set(const char* name, glm::ivec2 value)
{
  this->program->SetUniform2i(name, glm::value_ptr(value));
}

void RayMarchProgram::Set(const char* name, glm::dvec2 value)
{
  this->program->SetUniform2f(name, glm::value_ptr(glm::vec2(value)));
}

void RayMarchProgram::Set(const char* name, glm::dvec3 value)
{
  this->program->SetUniform3f(name, glm::value_ptr(glm::vec3(value)));
}

void RayMarchProgram::Set(const char* name, glm::dvec4 value)
{
  this->program->SetUniform4f(name, glm::value_ptr(glm::vec4(value)));
}

void RayMarchProgram::Set(const char* name, const glm::dmat3& value)
{
  glm::mat3 rounded(value);
  this->program->SetUniformMatrix3x3(name, glm::value_ptr(rounded));
}

void RayMarchProgram::Set(const char* name, const glm::dmat4& value)
{
  glm::mat4 rounded(value);
  this->program->SetUniformMatrix4x4(name, glm::value_ptr(rounded));
}

void RayMarchProgram::Set(const char* name, vtkTextureObject* activeTexture)
{
  this->program->SetUniformi(name, activeTexture->GetTextureUnit());
}

}
