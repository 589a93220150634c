#ifndef Varimarch_Scene_ReferencePicture_h
#define Varimarch_Scene_ReferencePicture_h

#include "Core/Reference/ReferenceImage.h"
#include "Scene/Scene.h"

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

}

#endif
