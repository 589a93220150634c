// Clipping planes end the part of a ray that is marched, at the very place where it meets them.

bool IsClipped(vec3 positionGrid)
{
  bool clipped = false;
  for (int i = 0; i < clippingPlaneCount; ++i)
  {
    clipped = clipped || dot(texelFetch(clippingPlanes, i), vec4(positionGrid, 1.0)) < 0.0;
  }
  return clipped;
}

Interval Clipped(Ray ray, Interval inside)
{
  for (int i = 0; i < clippingPlaneCount; ++i)
  {
    vec4 plane = texelFetch(clippingPlanes, i);
    float beyond = dot(plane, vec4(ray.originGrid, 1.0));
    float approach = dot(plane.xyz, ray.directionGrid);
    float crossing = -beyond / approach;
    inside.enter = approach > 0.0 ? max(inside.enter, crossing) : inside.enter;
    inside.exit = approach < 0.0 ? min(inside.exit, crossing) : inside.exit;
    inside.exit = approach == 0.0 && beyond < 0.0 ? inside.enter : inside.exit;
  }
  return inside;
}
