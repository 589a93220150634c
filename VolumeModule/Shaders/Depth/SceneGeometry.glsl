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
