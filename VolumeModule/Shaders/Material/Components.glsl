// Up to four components, as one material or a mixture of several. The extinctions and emissions of
// the mixed materials add up, as those of particles between each other do, in any order. A
// component's weight is its part of the mixture.

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec3 emission = vec3(0.0);
  float extinction = 0.0;
  for (int part = 0; part < materialCount; ++part)
  {
    vec4 optical = PartOptical(values.scalars, part);
    vec3 gradient = gradients.ofScalars[part];
    vec3 opacityGradient = gradients.ofScalars[OpacityComponent(part)];
    float absorbed = partWeights[part] * AtGradient(optical.a, opacityGradient, part);
    emission += absorbed * Shade(optical.rgb, gradient, reflectances[part], ray, t);
    extinction += absorbed;
  }
  return vec4(emission / max(extinction, 1e-30), extinction);
}
