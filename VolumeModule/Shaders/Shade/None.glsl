// Emission only: the transfer function's colour is what is seen.

vec3 Shade(vec3 color, vec3 gradient, Ray ray)
{
  return color;
}
