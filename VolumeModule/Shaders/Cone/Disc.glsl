#include "Math/LightCone.glsl"
// Lights may be as wide as a cone; their light is the mean over directions in it.

const int ConeDirections = 12;

// The point of the unit disc and the weight of each direction: Core/Geometry/LightCone.h.
vec3 DiscPoint(int index)
{
  float root = sqrt(29.0);
  vec2 corner = vec2((index & 1) == 0 ? 1.0 : -1.0, (index & 2) == 0 ? 1.0 : -1.0);
  if (index < 4)
  {
    vec2 onAxis = index < 2 ? vec2(corner.x, 0.0) : vec2(0.0, corner.x);
    return vec3(sqrt(0.75) * onAxis, 2.0 / 27.0);
  }
  float inner = index < 8 ? -1.0 : 1.0;
  return vec3(
    sqrt((27.0 + inner * 3.0 * root) / 104.0) * corner, (551.0 - inner * 41.0 * root) / 6264.0);
}

float MeanTransmitted(vec3 originGrid, vec3 towards, float farMm, float coneHeight)
{
  if (coneHeight == 0.0)
  {
    return Transmitted(originGrid, towards, farMm);
  }
  float sum = 0.0;
  for (int i = 0; i < ConeDirections; ++i)
  {
    vec3 point = DiscPoint(i);
    vec3 direction = DirectionInCone(towards, coneHeight, point.x, point.y);
    sum += CastersLeave(originGrid, direction, farMm)
      ? point.z * Transmitted(originGrid, direction, farMm)
      : 0.0;
  }
  return sum;
}
