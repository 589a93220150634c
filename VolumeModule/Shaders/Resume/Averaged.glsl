// Shows the mean of several rays in each pixel, from an image with more rays than pixels.

vec4 DrawnRay(Ray ray, Interval inside)
{
  ivec2 first = ivec2(gl_FragCoord.xy - viewportOriginPixels) * raysPerSide;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < raysPerSide; ++y)
  {
    for (int x = 0; x < raysPerSide; ++x)
    {
      sum += texelFetch(coarseTexture, first + ivec2(x, y), 0);
    }
  }
  return sum / float(raysPerSide * raysPerSide);
}
