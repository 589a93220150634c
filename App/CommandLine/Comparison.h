#ifndef Varimarch_CommandLine_Comparison_h
#define Varimarch_CommandLine_Comparison_h

#include "PictureError.h"
#include "Truth.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

/// One renderer's picture of a scene, and what it cost. Pictures are float pictures.
struct Measurement
{
  MapperKind kind;
  vtkSmartPointer<vtkImageData> picture;
  double sampleDistanceMm;
  PictureError error;           ///< against the truth
  double firstMs;               ///< the first picture, with everything it builds
  std::vector<double> roundsMs; ///< each later picture
  double medianMs;              ///< of these
};

struct Comparison
{
  Truth truth;
  std::vector<Measurement> measurements; ///< ours, VTK's GPU and VTK's CPU mapper
  std::string openglRenderer;
};

/// Draws a scene with our mapper and VTK's two, in turn, so that what else the machine does
/// disturbs all alike, and compares each with the truth.
/// A time is that of one vtkRenderWindow::Render, until the device has finished.
/// @param rounds   >= 1, after a first picture of each that builds what it needs
/// @param onStep   called with what is being done now
/// @throws std::runtime_error when one of them reports an error
Comparison Compare(const Scene& scene, vtkImageData* image, int rounds, const OnStep& onStep);

}

#endif
