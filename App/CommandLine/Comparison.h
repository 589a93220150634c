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

/// One mapper's image of a scene, its error and its times.
struct Measurement
{
  MapperKind kind;
  vtkSmartPointer<vtkImageData> picture; ///< float image
  double sampleDistanceMm;
  PictureError error;           ///< error against the truth
  double firstMs;               ///< time of the first frame, including everything that it builds
  std::vector<double> roundsMs; ///< times of the later frames
  double medianMs;              ///< median of the rounds
};

struct Comparison
{
  Truth truth;
  std::vector<Measurement> measurements; ///< our mapper, VTK's GPU mapper and VTK's CPU mapper
  std::string openglRenderer;
};

/// Draws a scene with our mapper and VTK's two, in alternation, so that other processes disturb all
/// equally, and compares each image with the truth. A time is that of one vtkRenderWindow::Render,
/// until the device has finished.
/// @param rounds   number of frames after each mapper's first, >= 1
/// @param paths    the truth is traced by them, if there are any
/// @param onStep   called with a description of each step
/// @throws std::runtime_error when a mapper reports an error
Comparison Compare(const Scene& scene, vtkImageData* image, int rounds, const PathSettings& paths,
  const OnStep& onStep);

}

#endif
