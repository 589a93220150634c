// Interpolates an image with fewer rays than pixels, by the cubic of Catmull and Rom, limited to
// the range of the nearest rays. Near an edge of opaque geometry the interpolation is linear,
// between the rays that end where the ray of the pixel would end.

vec4 CubicWeights(float x)
{
  return 0.5 *
    vec4(x * (x * (2.0 - x) - 1.0), x * x * (3.0 * x - 5.0) + 2.0, x * (x * (4.0 - 3.0 * x) + 1.0),
      x * x * (x - 1.0));
}

// The first and the last weight are for pixels whose nearest rays all end at other surfaces.
vec4 LinearWeights(float x)
{
  const float Beyond = 0.01;
  return vec4(Beyond * (1.0 - x), 1.0 - x, x, Beyond * x);
}

vec4 DrawnRay(Ray ray, Interval inside)
{
  vec2 place = (gl_FragCoord.xy - viewportOriginPixels) * coarsePerPixel - 0.5;
  vec2 fraction = fract(place);
  ivec2 first = ivec2(floor(place)) - 1;
  vec4 cubicX = CubicWeights(fraction.x);
  vec4 cubicY = CubicWeights(fraction.y);
  vec4 linearX = LinearWeights(fraction.x);
  vec4 linearY = LinearWeights(fraction.y);
  vec4 cubic = vec4(0.0);
  vec4 trusted = vec4(0.0);
  float weights = 0.0;
  float leastTrust = 1.0;
  vec4 smallest = vec4(3e38);
  vec4 largest = vec4(-3e38);
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      ivec2 coarsePixel = clamp(first + ivec2(x, y), ivec2(0), lastCoarsePixel);
      vec4 coarse = texelFetch(coarseTexture, coarsePixel, 0);
      float trust = Trust(ray, inside, coarsePixel);
      float weight = trust * linearX[x] * linearY[y];
      cubic += cubicX[x] * cubicY[y] * coarse;
      trusted += weight * coarse;
      weights += weight;
      leastTrust = min(leastTrust, trust);
      bool isNext = (x == 1 || x == 2) && (y == 1 || y == 2);
      smallest = isNext ? min(smallest, coarse) : smallest;
      largest = isNext ? max(largest, coarse) : largest;
    }
  }
  const float OneSurface = 0.25;
  return leastTrust < OneSurface ? trusted / weights : clamp(cubic, smallest, largest);
}
