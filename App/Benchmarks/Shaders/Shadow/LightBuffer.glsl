// The light that the slices between a slice and the light let through.

uniform mat4 lightFromGrid;
uniform sampler2D lightTexture; // fraction of the light that arrives

float Arriving(Ray ray)
{
  vec2 place = (lightFromGrid * vec4(ray.originGrid, 1.0)).xy * 0.5 + 0.5;
  return textureLod(lightTexture, place, 0.0).r;
}
