#ifndef Varimarch_Benchmarks_CutRays_h
#define Varimarch_Benchmarks_CutRays_h

#include "Core/Geometry/Box.h"

#include <vtkVolumeMapper.h>

#include <glm/mat4x4.hpp>

#include <vector>

namespace varimarch
{

/// The parts of a ray that a mapper's clipping planes and cropping keep, by VTK's definition:
/// tested point by point in world and data space, without any formula of the mapper.
class CutRays
{
public:
  CutRays(vtkVolumeMapper* mapper, const glm::dmat4& worldFromGrid, const glm::dmat4& dataFromGrid);

  std::vector<Interval> operator()(const Ray& rayGrid, Interval inside) const;

private:
  bool IsLeft(glm::dvec3 positionGrid) const;

  vtkVolumeMapper* mapper;
  glm::dmat4 worldFromGrid;
  glm::dmat4 dataFromGrid;
};

}

#endif
