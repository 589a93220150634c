#include "ComparisonProgram.h"

#include "Core/Recipe/ShaderAssembly.h"
#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

std::string ShaderText(const std::string& path)
{
  const std::vector<ShaderTableRow>& own = ComparisonShaders();
  const auto found = std::find_if(
    own.begin(), own.end(), [&](const ShaderTableRow& row) { return path == row.path; });
  return found == own.end() ? LoadShaderFiles({ path }).front().text : found->text;
}

std::string Assembled(vtkShader::Type type, const std::vector<std::string>& paths)
{
  std::vector<ShaderFile> files;
  for (const std::string& path : paths)
  {
    files.push_back({ path, ShaderText(path) });
  }
  files = WithIncludes(files, ShaderText);
  const std::string source = AssembleShader(files);
  vtkNew<vtkShader> shader;
  shader->SetType(type);
  shader->SetSource(source);
  const bool compiles = shader->Compile();
  const std::string messages = shader->GetError();
  shader->Cleanup();
  if (!compiles)
  {
    throw std::runtime_error(
      "Cannot compile the shader of a comparison method: " + TraceShaderErrors(messages, files));
  }
  return source;
}

}

void ComparisonProgram::Use(vtkOpenGLRenderWindow* window, const std::string& vertexFile,
  const std::vector<std::string>& fragmentFiles)
{
  std::vector<std::string> key = fragmentFiles;
  key.push_back(vertexFile);
  Sources& sources = this->sourcesOfFiles[key];
  if (sources.vertex.empty())
  {
    sources = { Assembled(vtkShader::Vertex, { vertexFile }),
      Assembled(vtkShader::Fragment, fragmentFiles) };
  }
  this->program = window->GetShaderCache()->ReadyShaderProgram(
    sources.vertex.c_str(), sources.fragment.c_str(), "");
  if (!this->program)
  {
    throw std::runtime_error("Cannot link the shader of a comparison method: " + vertexFile);
  }
}

void ComparisonProgram::Set(const char* name, int value)
{
  this->program->SetUniformi(name, value);
}

void ComparisonProgram::Set(const char* name, float value)
{
  this->program->SetUniformf(name, value);
}

void ComparisonProgram::Set(const char* name, const glm::vec2& value)
{
  this->program->SetUniform2f(name, glm::value_ptr(value));
}

void ComparisonProgram::Set(const char* name, const glm::ivec2& value)
{
  this->program->SetUniform2i(name, glm::value_ptr(value));
}

void ComparisonProgram::Set(const char* name, const glm::vec3& value)
{
  this->program->SetUniform3f(name, glm::value_ptr(value));
}

void ComparisonProgram::Set(const char* name, const glm::vec4& value)
{
  this->program->SetUniform4f(name, glm::value_ptr(value));
}

void ComparisonProgram::Set(const char* name, const glm::mat3& value)
{
  glm::mat3 columns = value; // VTK takes a pointer to numbers that are not const
  this->program->SetUniformMatrix3x3(name, glm::value_ptr(columns));
}

void ComparisonProgram::Set(const char* name, const glm::mat4& value)
{
  glm::mat4 columns = value;
  this->program->SetUniformMatrix4x4(name, glm::value_ptr(columns));
}

void ComparisonProgram::Set(const char* name, vtkTextureObject* texture)
{
  if (this->program->IsUniformUsed(name))
  {
    texture->Activate();
    this->program->SetUniformi(name, texture->GetTextureUnit());
    this->activeTextures.push_back(texture);
  }
}

void ComparisonProgram::DeactivateTextures()
{
  for (vtkTextureObject* const texture : this->activeTextures)
  {
    texture->Deactivate();
  }
  this->activeTextures.clear();
}

void ComparisonProgram::SetTriangles(const std::vector<glm::vec3>& corners)
{
  this->cornerCount = corners.size();
  if (!corners.empty())
  {
    this->vertices->Upload(
      &corners.front().x, 3 * corners.size(), vtkOpenGLBufferObject::ArrayBuffer);
  }
}

void ComparisonProgram::Draw(std::size_t firstCorner, std::size_t cornerCount)
{
  if (cornerCount == 0)
  {
    return;
  }
  if (this->attributesOf != this->program)
  {
    this->attributes->ShaderProgramChanged();
    this->attributesOf = this->program;
  }
  this->attributes->Bind();
  this->vertices->Bind();
  this->attributes->AddAttributeArray(
    this->program, this->vertices, "vertexGrid", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
  glDrawArrays(GL_TRIANGLES, GLint(firstCorner), GLsizei(cornerCount));
  this->vertices->Release();
  this->attributes->Release();
}

void ComparisonProgram::Release()
{
  this->attributes->ReleaseGraphicsResources();
  this->attributesOf = nullptr;
  this->vertices->ReleaseGraphicsResources();
  this->program = nullptr;
  this->sourcesOfFiles.clear();
}

}
