// The product's light at the eye, from its slot Shade.

vec3 LitColor(vec3 color, float arriving, vec3 positionTexture, Ray ray)
{
  return arriving * Shade(color, GradientAt(positionTexture), reflectances[0], ray, 0.0);
}
