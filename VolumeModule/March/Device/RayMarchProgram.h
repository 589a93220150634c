#ifndef Varimarch_March_Device_RayMarchProgram_h
#define Varimarch_March_Device_RayMarchProgram_h

#include "Core/Recipe/RenderSettings.h"
#include "Frame/UserShaderCode.h"

#include "vtkNew.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace varimarch
{

/// The shader program of a recipe, ready to take uniforms. Programs are compiled once per recipe
/// and window: VTK's shader cache keeps them by their text.
class RayMarchProgram
{
public:
  /// Makes the program of the settings current. True when it had to be made.
  /// @throws std::runtime_error with the compiler's messages, traced to the shader files
  bool Use(vtkOpenGLRenderWindow* window, const RenderSettings& settings,
    const UserShaderCode& userCode = {});

  /// The uniforms of another program that are those of one of its volumes, by their names where
  /// there is but one.
  void Share(const RayMarchProgram& whole, std::size_t volume);

  vtkShaderProgram* Program() const { return this->program; }
  const std::vector<std::string>& Parts() const { return this->parts; }

  // Uniforms are computed in double and rounded once, here.
  void Set(const char* name, int value);
  void Set(const char* name, double value);
  void Set(const char* name, glm::ivec2 value);
  void Set(const char* name, glm::dvec2 value);
  void Set(const char* name, glm::dvec3 value);
  void Set(const char* name, glm::dvec4 value);
  void Set(const char* name, const glm::dmat3& value);
  void Set(const char* name, const glm::dmat4& value);
  void Set(const char* name, vtkTextureObject* activeTexture);

  /// The volume's own uniforms; then its mapper tells its observers of the shader.
  void SetUniformsOf(vtkVolume* volume);

  template <class Vector, std::size_t Count>
  void Set(const char* name, const std::array<Vector, Count>& values)
  {
    for (std::size_t i = 0; i < Count; ++i)
    {
      this->Set((name + ("[" + std::to_string(i) + "]")).c_str(), values[i]);
    }
  }

  void Forget();

private:
  struct Sources
  {
    std::string vertex;
    std::string fragment;
    std::string failure; ///< why these sources are no program; empty while they are
  };
  static Sources Assemble(const std::vector<std::string>& parts, const UserShaderCode& userCode);

  std::string NameOf(const char* name) const; ///< in the program

  vtkShaderProgram* program = nullptr; ///< the cache's
  std::optional<std::size_t> volume;   ///< whose uniforms are meant, where it is not all of it
  std::vector<std::string> parts;
  /// All that were asked for so far, by their parts and what a user has put in their place.
  std::map<std::vector<std::string>, Sources> sourcesOfParts;
};

}

#endif
