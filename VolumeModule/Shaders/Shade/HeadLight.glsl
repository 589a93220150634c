#include "Math/BlinnPhong.glsl"
// A light at the eye. Both sides of a surface are lit; where the gradient vanishes only ambient
// light is left, as in VTK.

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  vec3 normal = worldFromGradient * gradient;
  float facing = FacingEye(normal, dot(normal, worldFromGrid * ray.directionGrid));
  return LitFromEye(color, facing, LitPart(gradient), reflectance, diffuseLight, specularLight);
}
