#include "Math/BlinnPhong.glsl"
// Any number of lights: at the eye, distant, or near with attenuation and a cone. A surface faces
// the side where the value falls; with one side lit, its back has ambient light only. All lights at
// the eye are one light, and only the direction to a near light is computed for each sample.

const int TexelsPerLight = 5;

// Each light has five texels: its direction or position; its diffuse color and the cosine of its
// cone; its specular color and the exponent of the cone; its attenuation; the axis of the cone.

float ReachOf(int texel, float distanceMm, vec3 toLight)
{
  return LightReach(texelFetch(lightTexels, texel + 3).xyz, distanceMm, toLight,
    texelFetch(lightTexels, texel + 4).xyz, texelFetch(lightTexels, texel + 1).w,
    texelFetch(lightTexels, texel + 2).w);
}

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  vec3 inward = worldFromGradient * gradient;
  vec3 normal = -InverseLength(inward) * inward;
  vec3 positionWorld = worldFromGrid * PositionGrid(ray, t) + worldOfGridOrigin;
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  Reach reach = ReachAt(ray, t);
  float litPart = LitPart(gradient);
  vec2 atEye =
    SentToEye(Reflected(normal, toEye, toEye, reflectance.w, backsLit), litPart, toEye, toEye, 1.0);
  vec3 diffuse = atEye.x * diffuseLight;
  vec3 specular = atEye.y * specularLight;
  for (int texel = 0; texel < TexelsPerLight * distantCount; texel += TexelsPerLight)
  {
    vec3 toLight = texelFetch(lightTexels, texel).xyz;
    vec2 sent = SentToEye(Reflected(normal, toLight, toEye, reflectance.w, backsLit), litPart,
      toLight, toEye, Reaching(reach, texel / TexelsPerLight));
    diffuse += sent.x * texelFetch(lightTexels, texel + 1).rgb;
    specular += sent.y * texelFetch(lightTexels, texel + 2).rgb;
  }
  int firstNear = TexelsPerLight * distantCount;
  for (int texel = firstNear; texel < firstNear + TexelsPerLight * nearCount;
       texel += TexelsPerLight)
  {
    vec3 toPlace = texelFetch(lightTexels, texel).xyz - positionWorld;
    float distanceMm = max(length(toPlace), 1e-15);
    vec3 toLight = toPlace / distanceMm;
    vec2 sent = ReachOf(texel, distanceMm, toLight) *
      SentToEye(Reflected(normal, toLight, toEye, reflectance.w, backsLit), litPart, toLight, toEye,
        Reaching(reach, texel / TexelsPerLight));
    diffuse += sent.x * texelFetch(lightTexels, texel + 1).rgb;
    specular += sent.y * texelFetch(lightTexels, texel + 2).rgb;
  }
  return LitByAll(color, PartOfSent(litPart), reflectance, ambientLight, diffuse, specular);
}
