#ifndef Varimarch_CommandLine_Truth_h
#define Varimarch_CommandLine_Truth_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

namespace varimarch
{

/// Told what is being done now.
using OnStep = std::function<void(const std::string&)>;

/// What a scene's picture should be.
struct Truth
{
  vtkSmartPointer<vtkImageData> picture; ///< float picture
  double largestError;                   ///< estimate, of a channel in [0, 1]
  double seconds;                        ///< that it took, little where it was kept
};

/// Integrates the picture in double precision, see ReferencePicture, or takes it from the cache of
/// those that were drawn before.
/// @throws std::invalid_argument for a volume without scalars, or with several components
Truth TruthOf(const Scene& scene, vtkImageData* image, const OnStep& onStep);

/// How it came about, as a clause for people.
std::string Described(const Truth& truth);

}

#endif
