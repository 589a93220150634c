#ifndef Varimarch_Scene_ReferenceRequest_h
#define Varimarch_Scene_ReferenceRequest_h

#include "Core/HeadLightShading.h"
#include "Core/ReferenceImage.h"
#include "Scene/ReferencePicture.h"
#include "VolumeGeometry.h"

#include <vtkDataArray.h>

#include <optional>

namespace varimarch
{

/// All that a reference picture depends on, and nothing else.
struct ReferenceRequest
{
  vtkSmartPointer<vtkDataArray> scalars;
  VolumeGeometry geometry;
  TransferFunction transferFunction;
  std::optional<HeadLight> light; ///< none: unshaded
  Blend blend;
  ReferenceView view;
  double tolerance;
};

/// @throws std::invalid_argument for a volume without scalars, or with several components
ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance);

/// @return nothing when `progress` gave up
std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress);

}

#endif
