// The product's light at the eye, from its slot Shade.

vec3 LitColor(vec3 color, vec3 positionTexture, Ray ray)
{
  return Shade(color, GradientAt(positionTexture), reflectances[0], ray, 0.0);
}
