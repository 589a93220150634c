#include "Scene/ReferencePicture.h"

#include "Scene/ReferenceRequest.h"

namespace varimarch
{

std::optional<ReferencePicture> DrawReferencePicture(
  const Scene& scene, vtkImageData* image, double tolerance, const ProgressFunction& progress)
{
  return DrawReferencePicture(ReferenceRequestFor(scene, image, tolerance), progress);
}

}
