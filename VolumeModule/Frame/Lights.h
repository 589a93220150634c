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

/// The plain head lights of the renderer that are switched on, as one light.
HeadLightColors HeadLightColorsOf(vtkRenderer* renderer);

/// True if the only light is a head light that shines on both sides of surfaces. This usual case
/// has a shader that does less.
bool HasHeadLightOnly(vtkRenderer* renderer);

/// The light that multiplies the ambient coefficient: as in VTK the sum of the lights' ambient
/// colours, which are black by default, but white if there are head lights only.
glm::dvec3 AmbientLightOf(vtkRenderer* renderer);

/// The other lights that are switched on, in the world, as Shaders/Shade/Lights.glsl reads them.
/// The texels are never empty.
struct LightTexels
{
  int distantCount = 0; ///< Lights that shine from one direction; they come first.
  int nearCount = 0;
  std::vector<glm::vec4> texels;
};

LightTexels LightTexelsOf(vtkRenderer* renderer);

}

#endif
