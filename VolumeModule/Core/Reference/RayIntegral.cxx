#include "Core/Reference/RayIntegral.h"

#include "Core/Reference/CompositeIntegral.h"
#include "Core/Reference/ExtremeIntegral.h"
#include "Core/Reference/GrayIntegral.h"
#include "Core/Reference/IsosurfaceIntegral.h"
#include "Core/Reference/MaterialIntegral.h"

#include <stdexcept>

namespace varimarch
{

std::unique_ptr<const RayIntegral> NewRayIntegral(ReferenceScene scene, double tolerance)
{
  switch (scene.blend)
  {
    case Blend::Composite:
      if (scene.material)
      {
        return std::make_unique<MaterialIntegral>(std::move(scene), tolerance);
      }
      return std::make_unique<CompositeIntegral>(std::move(scene), tolerance);
    case Blend::MaximumIntensity:
      return std::make_unique<ExtremeIntegral>(std::move(scene), Extreme::Largest);
    case Blend::MinimumIntensity:
      return std::make_unique<ExtremeIntegral>(std::move(scene), Extreme::Smallest);
    case Blend::AverageIntensity:
      return std::make_unique<AverageIntegral>(std::move(scene), tolerance);
    case Blend::Additive:
      return std::make_unique<AdditiveIntegral>(std::move(scene), tolerance);
    case Blend::Isosurface:
      return std::make_unique<IsosurfaceIntegral>(std::move(scene));
    case Blend::Slice:
      break;
  }
  throw std::invalid_argument(
    "Reference image: slices are not supported; choose another blend mode");
}

}
