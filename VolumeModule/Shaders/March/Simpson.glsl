// Simpson's rule for optical depth and colour together; order 4 where both are smooth. A panel has
// samples at its beginning, middle and end. Its optical depths, to the middle and to the end, are
// integrals of the parabola through the three extinctions. Its colour is the mean of the three
// colours, each weighted by the light that is emitted there and reaches the front. This mean, times
// the exact absorption, keeps the result between the three colours, however dense the panel is.

const int PanelsPerSegment = 2;
float StepsPerSegment()
{
  return 4.0;
}

Accumulation TakeLeftOut(Accumulation sum, Ray ray, float t, float lengthMm)
{
  return sum;
}

Accumulation TakeSegment(Accumulation sum, Ray ray, float enterSegment, float lengthMm)
{
  float panelMm = lengthMm / float(PanelsPerSegment);
  vec4 start = Classify(ScalarAt(PositionTexture(ray, enterSegment)));
  for (int panel = 0; panel < PanelsPerSegment; ++panel)
  {
    float enter = enterSegment + float(panel) * panelMm;
    vec4 middle = Classify(ScalarAt(PositionTexture(ray, enter + 0.5 * panelMm)));
    vec4 end = Classify(ScalarAt(PositionTexture(ray, enter + panelMm)));
    float depth = (start.a + 4.0 * middle.a + end.a) * (panelMm / 6.0);
    float depthOfHalf =
      clamp((5.0 * start.a + 8.0 * middle.a - end.a) * (panelMm / 24.0), 0.0, depth);
    vec3 weights =
      vec3(start.a, 4.0 * middle.a * exp(-depthOfHalf), end.a * exp(-min(depth, 80.0)));
    vec3 color = mat3(start.rgb, middle.rgb, end.rgb) * weights;
    float total = weights.x + weights.y + weights.z;
    sum = BlendPart(sum, color / max(total, 1e-30), depth);
    start = end;
  }
  return sum;
}
