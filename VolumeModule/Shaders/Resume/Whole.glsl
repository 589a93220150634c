// The volume is one block: each ray is marched at once.

vec4 DrawnRay(Ray ray, Interval inside)
{
  return Probed(Windowed(BlendResult(MarchCropped(ray, inside, BlendBegin()))));
}
