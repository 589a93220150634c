#ifndef Varimarch_Scene_WorldVector_h
#define Varimarch_Scene_WorldVector_h

#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace varimarch
{

// A scene stores points and directions as plain arrays; these functions convert them to vectors and
// back.

inline glm::dvec3 VectorOf(const std::array<double, 3>& numbers)
{
  return glm::make_vec3(numbers.data());
}

inline std::array<double, 3> NumbersOf(const glm::dvec3& vector)
{
  return { vector.x, vector.y, vector.z };
}

}

#endif
