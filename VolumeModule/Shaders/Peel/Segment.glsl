// What is seen of the volume between two surfaces of translucent geometry, given by their depths.

float AtDepth(Ray ray, float depth)
{
  vec4 plane = clipDepthRow - (2.0 * depth - 1.0) * clipWeightRow;
  return -dot(plane, vec4(ray.originGrid, 1.0)) / dot(plane.xyz, ray.directionGrid);
}

vec4 Segment(Ray ray, Interval inside, float frontDepth, float backDepth)
{
  Interval part = Interval(
    max(inside.enter, AtDepth(ray, frontDepth)), min(inside.exit, AtDepth(ray, backDepth)));
  part.exit = frontDepth < backDepth ? part.exit : part.enter;
  return Windowed(BlendResult(MarchCropped(ray, part, BlendBegin())));
}
