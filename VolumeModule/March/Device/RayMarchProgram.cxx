#include "March/Device/RayMarchProgram.h"

#include "Core/Recipe/PassRecipe.h"
#include "Core/Recipe/ShaderAssembly.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/Device/GraphicsDriver.h"
#include "March/Device/ShaderFiles.h"
#include "VtkVersions.h"

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

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace varimarch
{

void UniformBuffer::Upload(unsigned int bindingPoint, const void* bytes, std::size_t count)
{
  if (this->handle == 0)
  {
    glGenBuffers(1, &this->handle);
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, bindingPoint, this->handle);
  glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(count), bytes, GL_STREAM_DRAW);
}

void UniformBuffer::Release()
{
  if (this->handle != 0)
  {
    glDeleteBuffers(1, &this->handle);
    this->handle = 0;
  }
}

namespace
{

// The compiler's messages; empty if the source compiles. This is called before VTK's shader cache
// compiles, because that would print the whole source with its own line numbers.
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

// The files, in which the user's texts replace the files of their slots.
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
        "The shader of this image has no slot " + slot + " to replace: it has" + known);
    }
    *file = { "//Varimarch::" + slot, text };
  }
  if (!code.uniforms.empty())
  {
    files.insert(files.begin() + 1, { "custom uniforms", code.uniforms });
  }
  return files;
}

// Connects a block of the program to a binding point.
void Bind(vtkShaderProgram* program, const std::string& block, unsigned int bindingPoint)
{
  const auto handle = GLuint(program->GetHandle());
  const GLuint index = glGetUniformBlockIndex(handle, block.c_str());
  if (index != GL_INVALID_INDEX)
  {
    glUniformBlockBinding(handle, index, bindingPoint);
  }
}

// The textures of a struct whose members are all textures.
template <class Textures>
const MarchTexture* TexturesIn(const Textures& textures)
{
  static_assert(sizeof(Textures) % sizeof(MarchTexture) == 0);
  return reinterpret_cast<const MarchTexture*>(&textures);
}

// The names of the members of such a struct, from its GLSL file.
template <class Textures>
std::vector<std::string> NamesOfTextures(const std::string& path, const Textures&)
{
  std::vector<std::string> names = SamplersOf(LoadShaderFiles({ path }).front().text);
  if (names.size() != sizeof(Textures) / sizeof(MarchTexture))
  {
    throw std::logic_error("A line of " + path + " declares more than one sampler, or none");
  }
  return names;
}

// The number of components that a vertex shader can pass on, less four for the position.
int MostFlatComponents()
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &most);
  return std::max(most - 4, 0);
}

// Binds the two outputs to their numbers; otherwise the linker is free to swap them.
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
  std::vector<ShaderFile> vertex = LoadShaderFiles(VertexShaderParts());
  std::vector<ShaderFile> fragment =
    WithIncludes(WithUserCode(LoadShaderFiles(parts), parts, userCode),
      [](const std::string& path) { return LoadShaderFiles({ path }).front().text; });
  // On graphics cards, uniforms are read at no cost.
  if (IsSoftwareRasterizer())
  {
    HandParametersOn(vertex, fragment, MostFlatComponents());
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
  // A shader without a march has no slots that a user may replace.
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
  // A failure is remembered, so that the shader is not compiled again for every frame.
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

void RayMarchProgram::SetRays(const RayParameters& parameters, const RayTextures& textures)
{
  static const std::vector<std::string> names = NamesOfTextures("RayTextures.glsl", textures);
  Bind(this->program, "RayParameters", 0);
  this->rays.Upload(0, parameters);
  this->Activate(names, TexturesIn(textures));
}

void RayMarchProgram::SetRayPixels(const MarchPlan& plan)
{
  const glm::ivec2 rays =
    plan.isTrial ? glm::ivec2(plan.viewport.width, plan.viewport.height) : glm::ivec2(0);
  for (const auto& [name, value] :
    { std::pair("trialRays", rays), std::pair("imagePixels", plan.ImagePixels()) })
  {
    if (this->program->IsUniformUsed(name))
    {
      this->program->SetUniform2i(name, glm::value_ptr(value));
    }
  }
}

void RayMarchProgram::SetVolume(std::size_t volume, std::size_t count,
  const VolumeParameters& parameters, const VolumeTextures& textures)
{
  static const std::vector<std::string> names = NamesOfTextures("VolumeTextures.glsl", textures);
  const auto nameOf = [&](const std::string& name)
  { return volume + 1 < count ? NameOfVolume(name, volume) : name; };
  std::vector<std::string> namesOfVolume;
  std::transform(names.begin(), names.end(), std::back_inserter(namesOfVolume), nameOf);
  this->volumes.resize(std::max(count, this->volumes.size()));
  Bind(this->program, nameOf("VolumeParameters"), unsigned(volume + 1));
  this->volumes[volume].Upload(unsigned(volume + 1), parameters);
  this->Activate(namesOfVolume, TexturesIn(textures));
}

void RayMarchProgram::Activate(const std::vector<std::string>& names, const MarchTexture* textures)
{
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    vtkTextureObject* const texture = textures[i].onDevice;
    if (texture && texture->GetHandle() && this->program->IsUniformUsed(names[i].c_str()))
    {
      texture->Activate();
      this->program->SetUniformi(names[i].c_str(), texture->GetTextureUnit());
      this->activeTextures.push_back(texture);
    }
  }
}

void RayMarchProgram::DeactivateTextures()
{
  for (vtkTextureObject* texture : this->activeTextures)
  {
    texture->Deactivate();
  }
  this->activeTextures.clear();
}

void RayMarchProgram::Release()
{
  this->program = nullptr;
  this->parts.clear();
  this->sourcesOfParts.clear();
  this->rays.Release();
  for (UniformBuffer& volume : this->volumes)
  {
    volume.Release();
  }
}

}
