#ifndef Varimarch_March_Device_RayMarchProgram_h
#define Varimarch_March_Device_RayMarchProgram_h

#include "Core/Parameters/MarchParameters.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/UserShaderCode.h"
#include "March/Device/MarchTextures.h"
#include "March/Device/UniformBuffer.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace varimarch
{

/// The shader program of a recipe, and the parameters and textures that it reads. Programs are
/// compiled once per recipe and window: VTK's shader cache keeps them by their text.
class RayMarchProgram
{
public:
  /// Makes the program of the settings current. True when it had to be made.
  /// @throws std::runtime_error with the compiler's messages, traced to the shader files
  bool Use(vtkOpenGLRenderWindow* window, const RenderSettings& settings,
    const UserShaderCode& userCode = {});

  vtkShaderProgram* Program() const { return this->program; }
  const std::vector<std::string>& Parts() const { return this->parts; }

  /// Uploads what the program reads beside its volumes, and activates the textures that it has.
  void SetRays(const RayParameters& parameters, const RayTextures& textures);

  /// The same for one of the volumes of the program.
  /// @param volume  in the order in which the shader has them
  /// @param count   of all of them
  void SetVolume(std::size_t volume, std::size_t count, const VolumeParameters& parameters,
    const VolumeTextures& textures);

  /// Deactivates the textures that were activated, after the drawing.
  void DeactivateTextures();

  /// The volume's own uniforms; then its mapper tells its observers of the shader.
  void SetUniformsOf(vtkVolume* volume);

  /// In the context that has its buffers.
  void Release();

private:
  struct Sources
  {
    std::string vertex;
    std::string fragment;
    std::string failure; ///< why these sources are no program; empty while they are
  };
  static Sources Assemble(const std::vector<std::string>& parts, const UserShaderCode& userCode);

  /// @param textures  in the order of the names
  void Activate(const std::vector<std::string>& names, vtkTextureObject* const* textures);

  vtkShaderProgram* program = nullptr; ///< the cache's
  std::vector<std::string> parts;
  /// All that were asked for so far, by their parts and what a user has put in their place.
  std::map<std::vector<std::string>, Sources> sourcesOfParts;
  UniformBuffer rays;
  std::vector<UniformBuffer> volumes;
  std::vector<vtkTextureObject*> activeTextures;
};

}

#endif
