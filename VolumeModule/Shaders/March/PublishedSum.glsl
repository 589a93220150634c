#include "Math/Absorption.glsl"
// The loop of Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016), section
// 3.3, to compare it with the other rules. Numbers are those of its printed lines. Slot Step gives
// the distance d: S(p) by Step/VariationField.glsl, or the step itself by Step/Fixed.glsl. The
// number i of steps done is (t - enter) / step; slot Span ends the ray where it exceeds the number
// wanted.
//
// C + VR(I) * s is the discrete sum of the paper with the opacity of one step, times s. It replaces
// s samples by s times the first, and may exceed 1. Order 1 at most.

Accumulation BlendSamples(Accumulation sum, vec4 optical, float samples)
{
  float opacity = Absorption(min(optical.a * stepMm, 100.0)) * samples;
  sum.color += sum.transmittance * opacity * optical.rgb;
  sum.transmittance = max(sum.transmittance * (1.0 - opacity), 0.0);
  return sum;
}

Accumulation March(Ray ray, Interval inside, Accumulation sum) // 1: C = 0
{
  float t = inside.enter; // 2: t = 0, 3: i = 0
  // 4: while (i < cant_steps)
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment = NextSegment(ray, inside, t, index, stepMm, BlendState(sum));
    vec3 p = PositionTexture(ray, segment.enter);                       // 6: p = r(t)
    float scalar = ScalarAt(p);                                         // 7: I = tex3D(p)
    float d = max(min(segment.exit, inside.exit) - segment.enter, 0.0); // 8: d = S(p)
    float s = d / stepMm;                                               // 9: s = d / step
    sum = BlendSamples(sum, Classify(scalar), s);                       // 10: C = C + VR(I) * s
    t = segment.exit; // 11: t = t + d, 12: i = i + s
  }
  return sum;
}
