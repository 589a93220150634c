#ifndef Varimarch_March_Device_RayMarchProgram_h
#define Varimarch_March_Device_RayMarchProgram_h

#include "Core/Parameters/MarchParameters.h"
#include "Core/Parameters/MarchTextures.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/MarchPlan.h"
#include "Frame/UserShaderCode.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace varimarch
{

/// The buffer of a uniform block on the graphics device.
class UniformBuffer
{
public:
  /// Uploads a struct with the memory layout of the block, and binds it.
  template <class Parameters>
  void Upload(unsigned int bindingPoint, const Parameters& parameters)
  {
    this->Upload(bindingPoint, &parameters, sizeof parameters);
  }

  /// Releases the buffer. Its OpenGL context must be current.
  void Release();

private:
  void Upload(unsigned int bindingPoint, const void* bytes, std::size_t count);

  unsigned int handle = 0; ///< OpenGL's name of the buffer; 0 if there is none.
};

/// The shader program of a recipe, and the parameters and textures that it reads. VTK's shader
/// cache keeps programs by their text, so each is compiled once per recipe and window.
class RayMarchProgram
{
public:
  /// Makes the program of the settings current. Returns true if it had to be compiled.
  /// @throws std::runtime_error with the compiler's messages, traced to the shader files
  bool Use(vtkOpenGLRenderWindow* window, const RenderSettings& settings,
    const UserShaderCode& userCode = {});

  vtkShaderProgram* Program() const { return this->program; }
  const std::vector<std::string>& Parts() const { return this->parts; }

  /// Uploads the parameters of the rays, and activates the textures that the program reads.
  void SetRays(const RayParameters& parameters, const RayTextures& textures);
  /// Sets which pixels have rays: see Shaders/Pixel/OfTrials.glsl.
  void SetRayPixels(const MarchPlan& plan);

  /// Does the same for one of the volumes of the program.
  /// @param volume  the index of the volume in the shader
  /// @param count   the number of volumes
  void SetVolume(std::size_t volume, std::size_t count, const VolumeParameters& parameters,
    const VolumeTextures& textures);

  /// Deactivates the textures after the drawing.
  void DeactivateTextures();

  /// Sets the custom uniforms of a volume, and lets its mapper invoke UpdateShaderEvent.
  void SetUniformsOf(vtkVolume* volume);

  /// Releases the buffers. Their OpenGL context must be current.
  void Release();

private:
  struct Sources
  {
    std::string vertex;
    std::string fragment;
    std::string failure; ///< The compiler's or linker's error; empty if there is none.
  };
  static Sources Assemble(const std::vector<std::string>& parts, const UserShaderCode& userCode);

  /// @param textures  one for each name
  void Activate(const std::vector<std::string>& names, const MarchTexture* textures);

  vtkShaderProgram* program = nullptr; ///< The current program; the cache owns it.
  std::vector<std::string> parts;
  /// The sources of all programs so far, by their files and the user's code.
  std::map<std::vector<std::string>, Sources> sourcesOfParts;
  UniformBuffer rays;
  std::vector<UniformBuffer> volumes;
  std::vector<vtkTextureObject*> activeTextures;
};

}

#endif
