// The depth, as in a depth buffer, at which a ray first meets anything visible.

uniform float leastOpacity;
uniform bool clampDepth; // where nothing is visible: to where the ray leaves the volume

vec4 DrawnRay(Ray ray, Interval inside)
{
  float t = FirstWithOpacity(ray, inside, leastOpacity);
  t = t < Nowhere || !clampDepth ? t : inside.exit;
  vec4 place = vec4(ray.originGrid + min(t, inside.exit) * ray.directionGrid, 1.0);
  float depth = 0.5 * dot(clipDepthRow, place) / dot(clipWeightRow, place) + 0.5;
  // Drawn over 0, which stands for what is not drawn: the far plane.
  return vec4(t < Nowhere ? 1.0 - depth : 0.0, 0.0, 0.0, 0.0);
}
