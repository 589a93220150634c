#ifndef Varimarch_Scene_ReferencePicture_h
#define Varimarch_Scene_ReferencePicture_h

#include "Core/Reference/ReferenceImage.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>

namespace varimarch
{

/// The truth about a scene's picture.
struct ReferencePicture
{
  /// As CaptureFloatImage makes them: RGBA, float, premultiplied, without the background.
  vtkSmartPointer<vtkImageData> image;
  double largestError; ///< the largest of the pixels' error estimates, of a channel in [0, 1]
};

/// Integrates the ray of every pixel of a scene's picture by Core/Reference/ReferenceIntegrator, on
/// all cores. Needs no OpenGL. What the scene says of how it is rendered does not matter.
/// @param image      the volume that the scene's source names, one component of any type
/// @param tolerance  largest accepted error of a channel; 1e-6 is beyond what a float picture of
///                   8 bit displays needs, and for shaded noise far cheaper than 1e-9
/// @return nothing when `progress` gave up
/// @throws std::invalid_argument for a volume without scalars, or with several components
std::optional<ReferencePicture> DrawReferencePicture(
  const Scene& scene, vtkImageData* image, double tolerance, const ProgressFunction& progress = {});

}

#endif
