#ifndef Varimarch_Frame_Lights_h
#define Varimarch_Frame_Lights_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkRenderer;

namespace varimarch
{

class NumberCheck;

/// The colours of head lights times their intensities.
struct HeadLightColors
{
  glm::dvec3 diffuse = glm::dvec3(0.0);
  glm::dvec3 specular = glm::dvec3(0.0);
};

/// The lights that are not plain head lights, in world space, in the layout of
/// Shaders/Shade/Lights.glsl. The texels are never empty. The fourth number of the first one is the
/// height of the light's cone, 1 - cos(softness). A lamp so far away that floats cannot hold the
/// square of its distance is a light at infinity, with the part of its light that arrives.
struct LightTexels
{
  static constexpr int PerLight = 5; ///< The first one has its direction or position.
  int distantCount = 0;              ///< The number of lights at infinity, which come first.
  int nearCount = 0;                 ///< The number of lights with a position.
  std::vector<glm::vec4> texels = { glm::vec4(0.0f) };

  int Count() const { return this->distantCount + this->nearCount; }
};

/// The lights of a renderer that are switched on.
struct SceneLights
{
  HeadLightColors head; ///< The sum of the plain head lights.
  /// The light that multiplies the ambient coefficient. As in VTK, it is the sum of the lights'
  /// ambient colours, which are black by default, but white if all lights are head lights.
  glm::dvec3 ambient = glm::dvec3(1.0);
  LightTexels lamps;
  bool areHeadLights = true; ///< True if there are no other lights.
  bool areTwoSided = true;   ///< True if they light both sides of surfaces.

  /// True in the usual case, which has a shorter shader.
  bool AreUsual() const { return this->areHeadLights && this->areTwoSided; }
};

SceneLights LightsOf(vtkRenderer* renderer, NumberCheck& check);

/// The number of rays by which all of these lights are traced from one place.
int RaysToLights(const LightTexels& lights);

}

#endif
