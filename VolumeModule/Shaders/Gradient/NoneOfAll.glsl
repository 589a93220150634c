// Nothing depends on gradients.

mat4x3 GradientsAllAt(vec3 positionTexture)
{
  return mat4x3(0.0);
}
