// Up to four components, as one material or a mixture of several. The extinctions and emissions of
// the mixed materials add up, as those of particles between each other do, in any order. A
// component's weight is its part of the mixture.

float PartExtinction(Values values, Gradients gradients, int part)
{
  vec3 opacityGradient = gradients.ofScalars[OpacityComponent(part)];
  return partWeights[part] * AtGradient(PartOptical(values.scalars, part).a, opacityGradient, part);
}

float ExtinctionIfAny(Values values, Gradients gradients, int part)
{
  return part < materialCount ? PartExtinction(values, gradients, part) : 0.0;
}

// A loop would count for llvmpipe in each segment of rays inside.
float MaterialExtinction(Values values, Gradients gradients)
{
  return ExtinctionIfAny(values, gradients, 0) + ExtinctionIfAny(values, gradients, 1) +
    ExtinctionIfAny(values, gradients, 2) + ExtinctionIfAny(values, gradients, 3);
}

vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t)
{
  vec3 emission = vec3(0.0);
  float extinction = 0.0;
  for (int part = 0; part < materialCount; ++part)
  {
    vec3 color = PartOptical(values.scalars, part).rgb;
    float absorbed = PartExtinction(values, gradients, part);
    emission +=
      absorbed * kept[part] * Shade(color, gradients.ofScalars[part], reflectances[part], ray, t);
    extinction += absorbed;
  }
  return vec4(emission / max(extinction, 1e-30), extinction);
}
