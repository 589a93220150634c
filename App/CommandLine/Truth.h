#ifndef Varimarch_CommandLine_Truth_h
#define Varimarch_CommandLine_Truth_h

#include "Scene/Reference/ReferencePicture.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

namespace varimarch
{

/// Called with a description of each step.
using OnStep = std::function<void(const std::string&)>;

/// The reference image of a scene.
struct Truth
{
  vtkSmartPointer<vtkImageData> picture; ///< float image
  double largestError; ///< estimated largest error, or standard error, of a channel in [0, 1]
  double seconds;      ///< time to integrate it, or to read it from the cache
  PathSettings paths;  ///< how it was traced, if it was
};

/// Integrates the image in double precision, see ReferencePicture, or takes it from the cache.
/// @throws std::invalid_argument for a volume without scalars, or with several components
Truth TruthOf(const Scene& scene, vtkImageData* image, const OnStep& onStep);

/// Traces the light that matter scatters, see DrawPathPicture.
/// @param paths  with at least 2 paths
Truth TruthByPaths(
  const Scene& scene, vtkImageData* image, const PathSettings& paths, const OnStep& onStep);

/// A noun phrase that describes how the image was made.
std::string Described(const Truth& truth);

/// The same in a few words.
std::string ShortlyDescribed(const Truth& truth);

}

#endif
