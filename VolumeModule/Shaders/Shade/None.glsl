// Colours are emitted as they are.

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  return color;
}
