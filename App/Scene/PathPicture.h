#ifndef Varimarch_Scene_PathPicture_h
#define Varimarch_Scene_PathPicture_h

#include "Scene/ReferencePicture.h"

namespace varimarch
{

/// How scattered light is traced.
struct PathSettings
{
  int paths = 0;           ///< number of random paths of each pixel, >= 2; 0: none
  int mostScatterings = 0; ///< on a path; 0: any number
};

/// The image of a scene whose colours scatter light, by Core/Reference/PathTracer. The albedo is
/// the colour times the coefficient of diffuse light. Ambient light stands for light from all
/// around, and surfaces and highlights are none. A thickness of a hundredth of the smallest
/// distance between voxels is at most of the optical depth 1.
/// @return the image, with the largest standard error of a channel; nothing if `progress` cancelled
/// @throws std::invalid_argument as DrawReferencePicture, and for scenes without shading, with
///         another blend mode than composite, or with cubic interpolation
std::optional<ReferencePicture> DrawPathPicture(const Scene& scene, vtkImageData* image,
  const PathSettings& settings, const ProgressFunction& progress = {});

}

#endif
