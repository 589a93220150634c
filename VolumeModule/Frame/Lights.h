#ifndef Varimarch_Frame_Lights_h
#define Varimarch_Frame_Lights_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkRenderer;

namespace varimarch
{

/// Colours of head lights times their intensities.
struct HeadLightColors
{
  glm::dvec3 diffuse = glm::dvec3(0.0);
  glm::dvec3 specular = glm::dvec3(0.0);
};

/// The plain head lights of the renderer that are on, as one.
HeadLightColors HeadLightColorsOf(vtkRenderer* renderer);

/// Whether one head light that shines on both sides of surfaces is all there is: the usual case,
/// for which there is a shader that does less.
bool HasHeadLightOnly(vtkRenderer* renderer);

/// What multiplies the ambient coefficient. As in VTK the sum of the lights' ambient colours, which
/// are black by default; but white where there are head lights only.
glm::dvec3 AmbientLightOf(vtkRenderer* renderer);

/// The other lights that are on, in the world, as Shaders/Shade/Lights.glsl reads them; never
/// empty.
struct LightTexels
{
  int distantCount = 0; ///< of those that shine from one direction, which come first
  int nearCount = 0;
  std::vector<glm::vec4> texels;
};

LightTexels LightTexelsOf(vtkRenderer* renderer);

}

#endif
