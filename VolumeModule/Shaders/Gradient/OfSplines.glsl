// Like OfSpline.glsl, for all components.

mat4x3 GradientsAllAt(vec3 positionTexture)
{
  return transpose(2.0 *
    mat3x4(SlopeAlong(vec3(1.0, 0.0, 0.0), positionTexture),
      SlopeAlong(vec3(0.0, 1.0, 0.0), positionTexture),
      SlopeAlong(vec3(0.0, 0.0, 1.0), positionTexture)));
}
