#ifndef Varimarch_Scene_ReferencePicture_h
#define Varimarch_Scene_ReferencePicture_h

#include "Core/Reference/ReferenceIntegrator.h"
#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>

namespace varimarch
{

/// The image that a scene should render to, with bounds on its error.
struct ReferencePicture
{
  /// Float image as from CaptureFloatImage: RGBA, float, premultiplied, without the background.
  vtkSmartPointer<vtkImageData> image;
  double largestError; ///< largest estimated error of a channel in [0, 1]
};

/// Integrates the ray of every pixel with Core/Reference/ReferenceIntegrator, on all cores. Needs
/// no OpenGL. The scene's render options do not matter.
/// @param image      the volume that the scene's source names: one component, any type
/// @param tolerance  largest accepted error of a channel. 1e-6 is below what an 8-bit display
///                   shows, and for shaded noise far cheaper than 1e-9
/// @return nothing if `progress` cancelled
/// @throws std::invalid_argument for a volume without scalars, or with several components
std::optional<ReferencePicture> DrawReferencePicture(
  const Scene& scene, vtkImageData* image, double tolerance, const ProgressFunction& progress = {});

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
