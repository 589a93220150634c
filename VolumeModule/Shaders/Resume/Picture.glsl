// All blocks are drawn: what each ray has gathered becomes its pixel.

vec4 DrawnRay(Ray ray, Interval inside)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  return Windowed(BlendResult(BlendResumed(texelFetch(gatheredTexture, pixel, 0))));
}
