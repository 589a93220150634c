#ifndef Varimarch_Benchmarks_Comparison_PassMethod_h
#define Varimarch_Benchmarks_Comparison_PassMethod_h

#include "ComparedView.h"
#include "ComparisonImage.h"

namespace varimarch
{

/// The settings of a march in passes.
struct PassSettings
{
  int stepsPerPass;          ///< > 0
  double leastTransmittance; ///< a ray ends when less light than this passes, [0, 1)
  std::string shadow;        ///< file of the slot Shadow, which may have rays of its own
};

/// Ray marching in several passes: J. Krueger, R. Westermann, "Acceleration techniques for
/// GPU-based volume rendering" (IEEE Visualization 2003), as in T. Gorkin's slides 40 to 46. The
/// front faces of the box give the positions at which rays enter; the back faces turn these into a
/// texture of directions and lengths; each pass marches some steps. After each, the rays that have
/// left the volume or met enough opacity get a depth that the depth test rejects. The eye must be
/// outside the volume.
class PassMethod
{
public:
  /// Leaves the picture in `image`, which is bound afterwards.
  void Draw(const ComparisonFrame& frame, ComparisonImage& image, const PassSettings& settings);

  int Passes() const { return this->passes; } ///< passes of the last picture
  void Release(vtkWindow* window);

private:
  void SetUpRays(const ComparisonFrame& frame);
  void March(const ComparisonFrame& frame, const PassSettings& settings, int firstStep);
  void EndRays(const ComparisonFrame& frame, ComparisonImage& image, double marchedMm,
    double leastTransmittance);

  ComparisonImage fronts;
  ComparisonImage directions;
  ComparisonImage ended; ///< a colour without use, for the framebuffer that writes depths
  vtkNew<vtkTextureObject> depth;
  int passes = 0;
};

}

#endif
