#ifndef Varimarch_Benchmarks_Comparison_ComparisonProgram_h
#define Varimarch_Benchmarks_Comparison_ComparisonProgram_h

#include "March/Device/ShaderFiles.h"

#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkTextureObject.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace varimarch
{

/// The shader files of the comparison methods, App/Benchmarks/Shaders. Shaders/MakeTable.cmake
/// writes the source of this function during the build.
const std::vector<ShaderTableRow>& ComparisonShaders();

/// A program of the comparison methods, and the triangles that it draws. Its files are those of
/// App/Benchmarks/Shaders and, under their own names, those of the product.
class ComparisonProgram
{
public:
  /// Makes the program of some files current.
  /// @throws std::runtime_error with the compiler's messages, traced to the files
  void Use(vtkOpenGLRenderWindow* window, const std::string& vertexFile,
    const std::vector<std::string>& fragmentFiles);

  /// Sets a uniform of the current program. Programs that do not have it ignore it.
  void Set(const char* name, int value);
  void Set(const char* name, float value);
  void Set(const char* name, const glm::vec2& value);
  void Set(const char* name, const glm::ivec2& value);
  void Set(const char* name, const glm::vec3& value);
  void Set(const char* name, const glm::vec4& value);
  void Set(const char* name, const glm::mat3& value);
  void Set(const char* name, const glm::mat4& value);

  /// Activates a texture that the program reads, until DeactivateTextures.
  void Set(const char* name, vtkTextureObject* texture);
  void DeactivateTextures();

  /// Replaces the triangles.
  void SetTriangles(const std::vector<glm::vec3>& corners);
  /// Draws some of the triangles with the current program.
  void Draw(std::size_t firstCorner, std::size_t cornerCount);
  void DrawAll() { this->Draw(0, this->cornerCount); }

  void Release();

private:
  struct Sources
  {
    std::string vertex;
    std::string fragment;
  };

  std::map<std::vector<std::string>, Sources> sourcesOfFiles;
  vtkShaderProgram* program = nullptr; ///< owned by the window's cache
  const vtkShaderProgram* attributesOf = nullptr;
  std::size_t cornerCount = 0;
  std::vector<vtkTextureObject*> activeTextures;
  vtkNew<vtkOpenGLBufferObject> vertices;
  vtkNew<vtkOpenGLVertexArrayObject> attributes;
};

/// An image of four floats per pixel that a comparison method blends its parts in.
class ComparisonImage
{
public:
  /// Binds the image with its size and a colour in all pixels.
  /// @param depth  a depth buffer of the same size, or null
  /// @throws std::runtime_error if OpenGL has no such framebuffer
  void Begin(vtkOpenGLRenderWindow* window, glm::ivec2 size, const glm::vec4& color,
    vtkTextureObject* depth = nullptr);

  /// Binds the image again, with its present pixels.
  void Continue(vtkOpenGLRenderWindow* window);

  vtkTextureObject* Color() { return this->color; }
  std::size_t Bytes() const; ///< 0 before the first Begin
  void Release(vtkWindow* window);

private:
  glm::ivec2 size = glm::ivec2(0);
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  vtkNew<vtkTextureObject> color;
};

/// The blending of what is drawn with what is there; colours are premultiplied.
enum class ComparisonBlending
{
  Replace,
  Over,  ///< over what is there, as from the back to the front
  Under, ///< under what is there, as from the front to the back
  Dim,   ///< dims what is there by the opacity of what is drawn
};

/// Sets the state in which comparison methods draw: that blending, both sides of triangles, no
/// depth test.
void SetComparisonState(vtkOpenGLRenderWindow* window, ComparisonBlending blending);

}

#endif
