#ifndef Varimarch_Scene_ReferenceRequest_h
#define Varimarch_Scene_ReferenceRequest_h

#include "Core/Look/HeadLightShading.h"
#include "Core/Reference/ReferenceImage.h"
#include "Frame/VolumeGeometry.h"
#include "Scene/ReferencePicture.h"

#include <vtkDataArray.h>

#include <glm/vec4.hpp>

#include <optional>
#include <vector>

namespace varimarch
{

/// Everything that a reference image depends on, and nothing else.
struct ReferenceRequest
{
  vtkSmartPointer<vtkDataArray> scalars;
  VolumeGeometry geometry;
  TransferFunction transferFunction;
  std::optional<HeadLight> light; ///< empty: unshaded
  Blend blend;
  std::vector<double> isovalues;
  std::optional<ValueRange> averagedRange; ///< empty: all values
  std::vector<glm::dvec4> cutPlanesGrid;   ///< keep what lies on their positive sides
  ReferenceView view;
  double tolerance;
};

/// @throws std::invalid_argument for a volume without scalars or with several components, and for
///         the parts of scenes that the reference does not draw: scissors, gradient opacity,
///         regions, lights other than that at the eye, damping, nearest and cubic interpolation
ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance);

/// @return nothing if `progress` cancelled
std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress);

}

#endif
