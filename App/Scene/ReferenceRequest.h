#ifndef Varimarch_Scene_ReferenceRequest_h
#define Varimarch_Scene_ReferenceRequest_h

#include "Core/Reference/ReferenceImage.h"
#include "Core/Reference/ReferenceIntegrator.h"
#include "Frame/VolumeGeometry.h"
#include "Scene/ReferenceCuts.h"
#include "Scene/ReferenceLighting.h"
#include "Scene/ReferencePicture.h"

#include <vtkDataArray.h>

#include <optional>
#include <vector>

namespace varimarch
{

/// Everything that a reference image depends on, and nothing else. Values are in units of the data.
struct ReferenceRequest
{
  vtkSmartPointer<vtkDataArray> scalars;
  VolumeGeometry geometry;
  double meanSpacingMm;
  double largestGradientPerMm; ///< see LargestRegionGradient
  Interpolation interpolation; ///< linear except in composites
  TransferFunction transferFunction;
  std::vector<OpacityNode> gradientOpacities; ///< see Look; empty except in composites
  std::vector<LookRegion> regions;            ///< see Look; empty except in composites
  std::optional<ReferenceLighting> lighting;  ///< empty: unshaded
  Occlusion occlusion;                        ///< with its reach; off except in composites
  Blend blend;
  std::vector<double> isovalues;
  std::optional<ValueRange> averagedRange; ///< empty: all values
  ReferenceCuts cuts;
  ReferenceView view;
  double tolerance;
};

/// @throws std::invalid_argument for a volume without scalars or with several components, and for
///         the parts of scenes that the reference does not draw: labels, a first distance, and
///         nearest or cubic interpolation except in composites
ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance);

/// The integrator that draws a request, which must outlive it.
ReferenceIntegrator IntegratorOf(const ReferenceRequest& request);

/// The image as VTK's data; nothing if there is none.
std::optional<ReferencePicture> PictureOf(const std::optional<ReferenceImage>& drawn);

/// @return nothing if `progress` cancelled
std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress);

}

#endif
