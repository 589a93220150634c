// Marches each ray through the whole volume.

vec4 DrawnRay(Ray ray, Interval inside)
{
  return Probed(Windowed(BlendResult(MarchCropped(ray, inside, BlendBegin()))));
}
