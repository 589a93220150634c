// Rays end at the opaque geometry drawn before, whose depth buffer was copied.

// Where the geometry at a pixel of this picture would end this ray, were it as deep here.
float DepthLimitAt(Ray ray, vec2 pixel)
{
  float depth = texelFetch(depthTexture, ivec2(pixel * depthPixelsPerPixel), 0).r;
  vec4 plane = clipDepthRow - (2.0 * depth - 1.0) * clipWeightRow;
  float approach = dot(plane.xyz, ray.directionGrid);
  float offset = -dot(plane, vec4(ray.originGrid, 1.0));
  return depth < 1.0 && approach != 0.0 ? offset / approach : 3.0e38;
}

float DepthLimit(Ray ray)
{
  return DepthLimitAt(ray, gl_FragCoord.xy - viewportOriginPixels);
}

// A ray that another surface has ended, or none, says nothing of this pixel: bilateral weights of
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
