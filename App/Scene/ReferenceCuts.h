#ifndef Varimarch_Scene_ReferenceCuts_h
#define Varimarch_Scene_ReferenceCuts_h

#include "Core/Geometry/Box.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace varimarch
{

/// The cuts of a reference image.
struct ReferenceCuts
{
  std::vector<glm::dvec4> planesGrid; ///< keep what lies on their positive sides
  vtkSmartPointer<vtkImageData> mask; ///< the mask of scissors, see Scissors.h; null without

  bool IsEmpty() const { return this->planesGrid.empty() && !this->mask; }

  /// The parts of a ray that the cuts leave, front to back, for ReferenceScene::uncutParts.
  /// @param dimensions  the number of the volume's voxels along each axis
  std::vector<Interval> PartsOf(const Ray& rayGrid, Interval inside, glm::ivec3 dimensions) const;
};

}

#endif
