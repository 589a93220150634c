// Nothing depends on the gradient.

vec3 GradientAt(vec3 positionTexture)
{
  return vec3(0.0);
}
