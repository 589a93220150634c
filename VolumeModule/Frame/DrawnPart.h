#ifndef Varimarch_Frame_DrawnPart_h
#define Varimarch_Frame_DrawnPart_h

#include <glm/vec3.hpp>

#include <vector>

class vtkCamera;
class vtkVolume;

namespace varimarch
{

/// The part of a volume's box that clipping planes and cropping leave, in world space. It is
/// convex: regions of cropping count as the box around them. It decides which of two volumes is in
/// front, so it need not be exact to more than a millionth of its size.
struct DrawnPart
{
  std::vector<glm::dvec3> corners; ///< Empty if nothing is left.
  std::vector<glm::dvec3> normals; ///< The normals of its faces, of length 1.

  glm::dvec3 Center() const; ///< That of the box around the corners along the world's axes.
  double Length() const;     ///< The length of the diagonal of that box [mm].
};

/// The drawn part of a volume whose mapper is a vtkVolumeMapper with an input; of a vtkMultiVolume,
/// its bounds. It has no corners if the volume has no finite bounds.
DrawnPart DrawnPartOf(vtkVolume* volume);

/// The sides of a plane on which two parts are, seen from a camera.
enum class Sides
{
  FirstInFront,
  SecondInFront,
  Unknown, ///< No plane separates the parts, or the camera looks along it.
};

/// Looks for a plane between two parts. The part on the camera's side of it covers the other.
Sides SidesOf(const DrawnPart& first, const DrawnPart& second, vtkCamera* camera);

}

#endif
