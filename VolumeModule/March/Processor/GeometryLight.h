#ifndef Varimarch_March_Processor_GeometryLight_h
#define Varimarch_March_Processor_GeometryLight_h

#include "Frame/Frame.h"
#include "Frame/Lights.h"
#include "March/Processor/GeometryReceivers.h"

#include <glm/vec3.hpp>

namespace varimarch
{

/// The light of opaque geometry as VTK's mapper of polygons draws it: ambient light, and diffuse
/// and specular light of each lamp by the model of Phong, both with the lamp's diffuse colour. It
/// tells what of the drawn colours stays where a volume takes a part of the lamps. Surfaces without
/// lighting, and those by physically based rendering, keep all of it. If the data or a block have
/// the colours, these count as white, which is exact without specular light. A texture multiplies
/// all light alike.
class GeometryLight
{
public:
  explicit GeometryLight(const Frame& frame);

  /// The factors of red, green and blue.
  /// @param parts  of each lamp that a volume may take light from, in the order of LightTexels
  template <class Parts>
  glm::dvec3 FactorsAt(const GeometryReceiver& receiver, const Parts& parts) const
  {
    const Look look = this->LookOf(receiver.surface);
    glm::dvec3 whole = look.ambient + this->HeadLightOn(receiver, look);
    glm::dvec3 left = whole;
    for (int lamp = 0; lamp < this->lights.Count(); ++lamp)
    {
      const glm::dvec3 own = this->LampOn(lamp, receiver, look);
      whole += own;
      left += parts(lamp) * own;
    }
    return Ratio(left, whole);
  }

private:
  /// The colours of a surface times its coefficients.
  struct Look
  {
    glm::dvec3 ambient;
    glm::dvec3 diffuse;
    glm::dvec3 specular;
    double power;
  };

  static glm::dvec3 Ratio(glm::dvec3 left, glm::dvec3 whole);
  Look LookOf(std::size_t surface) const;
  glm::dvec3 HeadLightOn(const GeometryReceiver& receiver, const Look& look) const;
  glm::dvec3 LampOn(int lamp, const GeometryReceiver& receiver, const Look& look) const;

  const Frame& frame;
  const LightTexels& lights;
  const HeadLightColors& head;
  glm::dvec3 towardsHeadWorld; ///< against the direction of the camera
};

}

#endif
