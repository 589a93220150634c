// Marches the parts of a ray between layers of translucent geometry, given by their depths.

float AtDepth(Ray ray, float depth)
{
  vec4 plane = clipDepthRow - (2.0 * depth - 1.0) * clipWeightRow;
  return -dot(plane, vec4(ray.originGrid, 1.0)) / dot(plane.xyz, ray.directionGrid);
}

vec4 Segment(Ray ray, Interval inside, vec2 depths)
{
  Interval part =
    Interval(max(inside.enter, AtDepth(ray, depths.x)), min(inside.exit, AtDepth(ray, depths.y)));
  part.exit = depths.x < depths.y ? part.exit : part.enter;
  return Windowed(BlendResult(MarchCropped(ray, part, BlendBegin())));
}

vec4 DrawnRay(Ray ray, Interval inside)
{
  vec4 depths = PeeledDepths();
  if (!(depths.x < depths.y) && !(depths.z < depths.w))
  {
    discard;
  }
  return Peeled(Segment(ray, inside, depths.xy), Segment(ray, inside, depths.zw));
}
