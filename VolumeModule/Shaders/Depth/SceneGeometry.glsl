#include "Math/Planes.glsl"
// Rays end at opaque geometry that was drawn before; its depth buffer was copied.

// The t at which the geometry at a pixel would end this ray, if it were as deep here [mm].
float DepthLimitAt(Ray ray, vec2 pixel)
{
  float depth = texelFetch(depthTexture, ivec2(pixel * depthPixelsPerPixel), 0).r;
  vec4 plane = clipDepthRow - (2.0 * depth - 1.0) * clipWeightRow;
  float approach = ApproachToPlane(plane, ray.directionGrid);
  float offset = -BeyondPlane(plane, ray.originGrid);
  return depth < 1.0 && approach != 0.0 ? offset / approach : 3.0e38;
}

float DepthLimit(Ray ray)
{
  return DepthLimitAt(ray, RayPixel());
}

// A bilateral weight by the ends of the two rays: Kopf et al., "Joint bilateral upsampling"
// (SIGGRAPH 2007). A ray that ends at another surface, or at none, does not represent this pixel.
float Trust(Ray ray, Interval inside, ivec2 coarsePixel)
{
  float here = DepthLimit(ray);
  float beside = DepthLimitAt(ray, (vec2(coarsePixel) + 0.5) / coarsePerPixel);
  // Geometry behind the volume shortens neither ray.
  float apart = here > inside.exit ? max(inside.exit - beside, 0.0) : abs(beside - here);
  float ofSurface = min(apart / sameSurfaceMm, 1e4);
  float trust = 1.0 / (1.0 + ofSurface * ofSurface);
  return trust * trust;
}
