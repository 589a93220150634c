#include "Math/BlinnPhong.glsl"
// One white, distant light on one side of surfaces, and white ambient light, as the product's slot
// Shade lights them. Shadows take the distant light alone.

vec3 LitColor(vec3 color, float arriving, vec3 positionTexture, Ray ray)
{
  vec3 inward = worldFromGradient * GradientAt(positionTexture);
  vec3 normal = -InverseLength(inward) * inward;
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  vec2 reflected = arriving * Reflected(normal, toLightWorld, toEye, reflectances[0].w, 0.0);
  return LitByAll(color, 1.0, reflectances[0], vec3(1.0), vec3(reflected.x), vec3(reflected.y));
}
