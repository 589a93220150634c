#include "Math/Absorption.glsl"
// The rule published by Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016),
// section 3.3, to compare its error with that of the other rules. Where the field says that the
// scalar varies little over a distance d, the sample at its beginning counts s = d / step times:
// C = C + VR(I) * s. This replaces the sum of many samples by its first term, and may exceed 1.
// Order 1 at most.

float StepsPerSegment()
{
  return 1.0;
}

Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm)
{
  return sum;
}

Accumulation TakeSegment(Accumulation sum, Ray ray, float enter, float lengthMm)
{
  vec4 optical = Classify(ScalarAt(PositionTexture(ray, enter)));
  float samples = max(lengthMm, 0.0) / stepMm;
  float opacity = Absorption(min(optical.a * stepMm, 100.0)) * samples;
  sum.color += sum.transmittance * opacity * optical.rgb;
  sum.transmittance = max(sum.transmittance * (1.0 - opacity), 0.0);
  return sum;
}
