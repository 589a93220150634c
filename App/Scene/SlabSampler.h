#ifndef Varimarch_Scene_SlabSampler_h
#define Varimarch_Scene_SlabSampler_h

#include "Scene/Scene.h"

#include <glm/vec3.hpp>
#include <vtkNew.h>

#include <cstdint>
#include <optional>

class vtkImageData;
class vtkImageInterpolator;

namespace varimarch
{

/// The thickness and the greys of a slice, as in SliceRequest.
struct SlabLook
{
  double window;
  double level;
  double slabMm;
  SlabBlend slabBlend;
  bool inverted;
};

/// The greys of the pixels of a plane or curved slice. Voxels are interpolated linearly; outside
/// the volume the image is black, inverted or not.
class SlabSampler
{
public:
  SlabSampler(vtkImageData* image, const SlabLook& look);
  ~SlabSampler();
  SlabSampler(const SlabSampler&) = delete;
  SlabSampler& operator=(const SlabSampler&) = delete;

  /// Distance of the samples through the slab.
  double StepMm() const { return this->stepMm; }

  /// @param index    continuous index of the voxels at the middle of the slab
  /// @param through  difference of the indices of a sample and the next
  std::uint8_t GrayAt(const glm::dvec3& index, const glm::dvec3& through) const;

private:
  std::optional<double> BlendedThrough(const glm::dvec3& index, const glm::dvec3& through) const;
  double Blended(double a, double b) const;
  std::optional<double> ValueAt(const glm::dvec3& index) const;

  SlabLook look;
  const int* extent;
  double stepMm;
  int steps; ///< samples on each side of the middle
  vtkNew<vtkImageInterpolator> interpolator;
};

}

#endif
