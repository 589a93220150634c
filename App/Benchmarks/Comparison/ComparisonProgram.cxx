#include "ComparisonProgram.h"

#include "Core/Recipe/ShaderAssembly.h"
#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
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

void ComparisonImage::Begin(vtkOpenGLRenderWindow* window, glm::ivec2 newSize,
  const glm::vec4& clear, vtkTextureObject* depth)
{
  if (this->size != newSize || !this->color->GetHandle())
  {
    this->size = newSize;
    this->color->ReleaseGraphicsResources(window);
    this->color->SetContext(window);
    this->color->SetMinificationFilter(vtkTextureObject::Linear);
    this->color->SetMagnificationFilter(vtkTextureObject::Linear);
    this->color->SetWrapS(vtkTextureObject::ClampToEdge);
    this->color->SetWrapT(vtkTextureObject::ClampToEdge);
    this->color->Allocate2D(unsigned(newSize.x), unsigned(newSize.y), 4, VTK_FLOAT);
  }
  this->framebuffer->SetContext(window);
  this->framebuffer->Bind();
  this->framebuffer->AddColorAttachment(0, this->color);
  if (depth)
  {
    this->framebuffer->AddDepthAttachment(depth);
  }
  else
  {
    this->framebuffer->RemoveDepthAttachment();
  }
  this->framebuffer->ActivateDrawBuffers(1);
  if (!this->framebuffer->CheckFrameBufferStatus(GL_FRAMEBUFFER))
  {
    throw std::runtime_error("A comparison method needs a framebuffer of 32 bit floats, and OpenGL "
                             "has none of " +
      std::to_string(newSize.x) + " x " + std::to_string(newSize.y) + " pixels");
  }
  this->Continue(window);
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  state->vtkglClearColor(clear.r, clear.g, clear.b, clear.a);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

void ComparisonImage::Continue(vtkOpenGLRenderWindow* window)
{
  this->framebuffer->Bind();
  window->GetState()->vtkglViewport(0, 0, this->size.x, this->size.y);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
}

std::size_t ComparisonImage::Bytes() const
{
  return this->color->GetHandle()
    ? 4 * sizeof(float) * std::size_t(this->size.x) * std::size_t(this->size.y)
    : 0;
}

void ComparisonImage::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
}

void SetComparisonState(vtkOpenGLRenderWindow* window, ComparisonBlending blending)
{
  vtkOpenGLState* const state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->SetEnumState(GL_BLEND, blending != ComparisonBlending::Replace);
  switch (blending)
  {
    case ComparisonBlending::Over:
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case ComparisonBlending::Under:
      state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
      break;
    case ComparisonBlending::Dim:
      state->vtkglBlendFuncSeparate(
        GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case ComparisonBlending::Replace:
      break;
  }
}

}
