#ifndef Varimarch_Frame_Lights_h
#define Varimarch_Frame_Lights_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkRenderer;

namespace varimarch
{

/// The colours of head lights times their intensities.
struct HeadLightColors
{
  glm::dvec3 diffuse = glm::dvec3(0.0);
  glm::dvec3 specular = glm::dvec3(0.0);
};

/// The sum of the renderer's plain head lights that are switched on.
HeadLightColors HeadLightColorsOf(vtkRenderer* renderer);

/// True if the only light is a head light that lights both sides of surfaces. This usual case has
/// a shorter shader.
bool HasHeadLightOnly(vtkRenderer* renderer);

/// The light that multiplies the ambient coefficient. As in VTK, it is the sum of the lights'
/// ambient colours, which are black by default, but white if all lights are head lights.
glm::dvec3 AmbientLightOf(vtkRenderer* renderer);

/// The other lights that are switched on, in world space, in the layout of
/// Shaders/Shade/Lights.glsl. The texels are never empty. The fourth number of the first one is the
/// height of the light's cone, 1 - cos(softness).
struct LightTexels
{
  static constexpr int PerLight = 5; ///< The first one has its direction or position.
  int distantCount = 0;              ///< The number of lights at infinity, which come first.
  int nearCount = 0;                 ///< The number of lights with a position.
  std::vector<glm::vec4> texels;
};

LightTexels LightTexelsOf(vtkRenderer* renderer);

/// The number of rays by which all of these lights are traced from one place.
int RaysToLights(const LightTexels& lights);

}

#endif
