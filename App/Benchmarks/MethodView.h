#ifndef Varimarch_Benchmarks_MethodView_h
#define Varimarch_Benchmarks_MethodView_h

#include "BenchMethods.h"
#include "Scene/OffscreenView.h"

#include <vtkSmartPointer.h>

#include <optional>

class vtkComparisonMapper;

namespace varimarch
{

/// A scene in a window, drawn by a method of the benchmarks.
class MethodView
{
public:
  /// @throws std::runtime_error if there is no OpenGL
  MethodView(const BenchMethod& method, const Scene& scene, vtkImageData* image);
  ~MethodView();

  OffscreenView& Offscreen() { return this->view; }
  void SetOptions(const RenderOptions& options);

  double UsedSampleDistanceMm() const; ///< the distance of the last frame
  double EstimatedError();             ///< our mapper's estimate, [0, 1]; 0 for others
  std::optional<double> Fetches();     ///< FetchesPerPixel; empty for methods of others
  std::optional<double> Bytes();       ///< GraphicsBytes; empty for VTK's mappers

private:
  OffscreenView view;
  vtkSmartPointer<vtkComparisonMapper> comparison; ///< null unless the method is one of others
};

}

#endif
