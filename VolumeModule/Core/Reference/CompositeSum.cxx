#include "Core/Reference/CompositeSum.h"

namespace varimarch
{

ReferenceColor CompositeSum::Color() const
{
  const double leftOut = this->Finished() ? this->transmittance : 0.0;
  return { glm::dvec4(this->rgb, 1.0 - this->transmittance), this->error + leftOut };
}

/// Source: Max, "Optical models for direct volume rendering" (IEEE TVCG 1995), equation 7.
void CompositeSum::AddHomogeneous(const OpticalProperties& properties, double lengthMm)
{
  if (properties.extinction == 0.0 || !(lengthMm > 0.0))
  {
    return;
  }
  const double absorption = -std::expm1(-properties.extinction * lengthMm);
  this->rgb += this->transmittance * absorption * properties.rgb;
  this->transmittance *= std::exp(-properties.extinction * lengthMm);
}

}
