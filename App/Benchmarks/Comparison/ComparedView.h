#ifndef Varimarch_Benchmarks_Comparison_ComparedView_h
#define Varimarch_Benchmarks_Comparison_ComparedView_h

#include "ComparisonVolume.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace varimarch
{

/// The view of a frame that a comparison method draws.
struct ComparedView
{
  vtkOpenGLRenderWindow* window;
  glm::ivec2 sizePixels;
  glm::ivec2 originPixels; ///< lower left corner in the framebuffer
  glm::dmat4 clipFromGrid;
  glm::dvec4 eyeGrid; ///< homogeneous; at infinity for a parallel projection
  glm::dvec3 eyeWorld;
  glm::dvec3 directionWorld; ///< unit vector in which the camera looks
  glm::dvec3 upWorld;        ///< unit vector, across the direction
  bool isParallel;
};

ComparedView ComparedViewOf(vtkRenderer* renderer, const VolumeGeometry& geometry);

/// Everything that a comparison method draws with. The image begins transparent.
struct ComparisonFrame
{
  const ComparedView& view;
  ComparisonVolume& volume;
  ComparisonProgram& program;
  double sampleDistanceMm; ///< > 0
  glm::dvec3 toLightWorld; ///< direction towards a distant light, a unit vector

  /// Makes a program with the volume's look current, and sets the uniforms of its slots.
  /// @param main    file with main(), for a fragment shader
  /// @param shadow  file of the slot Shadow
  void Use(const std::string& main, const std::string& shadow = NoShadow) const;
};

}

#endif
