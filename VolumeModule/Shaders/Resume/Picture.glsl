// Turns the state of each ray, after all blocks, into its pixel.

vec4 DrawnRay(Ray ray, Interval inside)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  return Windowed(BlendResult(BlendResumed(texelFetch(gatheredTexture, pixel, 0))));
}
