// Up to four components, as one material or a mixture of several: extinctions and emissions of what
// is mixed add up, as those of particles between each other do, whatever their order. The weight of
// a component is the part that it has in the mixture.

uniform vec2 visibleScalarsOf[4]; // only between these does a component absorb anything
uniform vec4 reflectances[4];
uniform float partWeights[4];

struct Values
{
  vec4 scalars;
};

struct Gradients
{
  mat4x3 ofScalars;
};

Values ValuesAt(vec3 positionTexture)
{
  return Values(TexelAt(positionTexture));
}

Gradients GradientsAt(vec3 positionTexture)
{
  return Gradients(GradientsAllAt(positionTexture));
}

Values Between(Values start, Values end, float along)
{
  return Values(mix(start.scalars, end.scalars, along));
}

Gradients Between(Gradients start, Gradients end, float along)
{
  return Gradients(start.ofScalars + along * (end.ofScalars - start.ofScalars));
}

bool MayAbsorb(Values start, Values end)
{
  bool may = false;
  for (int component = 0; component < 4; ++component)
  {
    vec2 visible = visibleScalarsOf[component];
    may = may ||
      (max(start.scalars[component], end.scalars[component]) > visible.x &&
        min(start.scalars[component], end.scalars[component]) < visible.y);
  }
  return may;
}

vec4 Material(Values values, Gradients gradients, Ray ray, float t)
{
  vec3 emission = vec3(0.0);
  float extinction = 0.0;
  for (int part = 0; part < PartCount; ++part)
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
