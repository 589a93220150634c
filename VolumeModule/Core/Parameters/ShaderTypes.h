#ifndef Varimarch_Core_Parameters_ShaderTypes_h
#define Varimarch_Core_Parameters_ShaderTypes_h

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>

/// The types of GLSL with their size and alignment in the layout std140 (OpenGL 4.6, section
/// 7.6.2.2), so that a struct can be uploaded as a uniform block. Assigning GLM's vectors and
/// matrices of doubles rounds them.
namespace varimarch::shader
{

/// A type of GLM with another alignment.
template <class Value, std::size_t Alignment>
struct alignas(Alignment) Aligned : Value
{
  Aligned() = default;

  template <class Other>
  Aligned(const Other& other)
    : Value(other)
  {
  }

  template <class... Numbers>
  Aligned(double first, Numbers... others)
    : Value(first, others...)
  {
  }
};

using vec2 = Aligned<glm::vec2, 8>;
using ivec2 = Aligned<glm::ivec2, 8>;
using vec3 = Aligned<glm::vec3, 16>;
using vec4 = Aligned<glm::vec4, 16>;
using mat4 = Aligned<glm::mat4, 16>;

struct mat3
{
  vec3 columns[3];

  mat3() = default;
  mat3(const glm::dmat3& matrix)
    : columns{ matrix[0], matrix[1], matrix[2] }
  {
  }

  const vec3& operator[](int column) const { return this->columns[column]; }
};

}

#endif
