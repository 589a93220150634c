// A ray that another surface has ended, or none, tells nothing of this pixel: bilateral weights of
// Kopf et al., "Joint bilateral upsampling" (SIGGRAPH 2007), by where the rays end.

float Trust(Ray ray, Interval inside, ivec2 coarsePixel)
{
  float here = DepthLimit(ray);
  float beside = DepthLimitAt(ray, (vec2(coarsePixel) + 0.5) / coarsePerPixel);
  // What ends both behind the volume ends neither in it.
  float apart = here > inside.exit ? max(inside.exit - beside, 0.0) : abs(beside - here);
  float ofSurface = min(apart / sameSurfaceMm, 1e4);
  float trust = 1.0 / (1.0 + ofSurface * ofSurface);
  return trust * trust;
}
