// Mixes the opacities that two materials have over a unit distance.
// @param part  the part of the second material, [0, 1]
// @return the extinction of the mixture; the mixture is never opaque. Needs Absorption.glsl and
//         Extinction.glsl.
float MixedExtinction(float first, float second, float part, float unitDistanceMm)
{
  float opacity = mix(Absorption(min(first * unitDistanceMm, 80.0f)),
    Absorption(min(second * unitDistanceMm, 80.0f)), part);
  return ExtinctionOf(min(opacity, 0.99999994f), unitDistanceMm);
}
