// Draws the image, and the depth at which a ray first meets anything visible. The part that is
// marched to find this depth is not marched again.

out vec4 fragOutput1;

vec4 DrawnRay(Ray ray, Interval inside)
{
  Located first = Locate(ray, inside, leastOpacity);
  float t = first.t < Nowhere || clampDepth == 0 ? first.t : inside.exit;
  vec3 place = ray.originGrid + min(t, inside.exit) * ray.directionGrid;
  fragOutput1 = t < Nowhere ? ColorOfPlace(place) : vec4(0.0);
  Interval rest = Interval(first.marched, inside.exit);
  return Probed(Windowed(BlendResult(MarchCropped(ray, rest, first.sum))));
}
