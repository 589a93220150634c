#ifndef Varimarch_Benchmarks_Comparison_HalfAngleMethod_h
#define Varimarch_Benchmarks_Comparison_HalfAngleMethod_h

#include "ComparedView.h"
#include "ComparisonImage.h"

#include <array>

namespace varimarch
{

/// Slices halfway between the view and a distant light, each drawn twice: for the eye, lit by what
/// the slices before it have let through, and for the light, whose buffer it dims. A blur of the
/// buffer from slice to slice scatters light forwards, as in a translucent material: T. Gorkin,
/// "Volume rendering using graphics hardware" (2009), slides 32 to 38, after J. Kniss and others,
/// GPU Gems (2004), chapter 39.
class HalfAngleMethod
{
public:
  /// Draws into `image`, which is bound afterwards.
  /// @param spreadDegrees  half the angle of the cone of scattered light, [0, 90); 0: shadows only
  void Draw(const ComparisonFrame& frame, ComparisonImage& image, double spreadDegrees);

  std::size_t Bytes() const; ///< both buffers of light
  void Release(vtkWindow* window);

private:
  /// Where the light shines, for one picture.
  struct Light
  {
    glm::dmat4 lightFromGrid; ///< to the square [-1, 1] that the light's buffer covers
    glm::vec2 blurTexture;    ///< radius of the blur between two slices [texture coordinates]
  };

  void DimLight(
    const ComparisonFrame& frame, const Light& light, const std::vector<glm::vec3>& slice);

  std::array<ComparisonImage, 2> buffers; ///< light before the present slice, and a copy to blur
  int present = 0;
};

}

#endif
