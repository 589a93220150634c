// Simpson's rule for the coupled pair of optical depth and colour, order 4 where all is smooth. A
// panel has samples at its beginning, middle and end. Optical depth is the integral of the parabola
// through the three extinctions, to the middle and to the end; the colour is the mean of the three,
// each weighted by what is emitted there and reaches the front. A weighted mean, times the exact
// absorption, keeps the result between the colours that are there, however dense the panel is.

const int PanelsPerSegment = 2;

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, 2.0 * float(PanelsPerSegment) * stepMm, BlendState(sum));
    if (segment.enter >= inside.exit)
    {
      break; // all that is left is invisible
    }
    t = min(segment.exit, inside.exit);
    float panelMm = (t - segment.enter) / float(PanelsPerSegment);
    vec4 start = Classify(ScalarAt(PositionTexture(ray, segment.enter)));
    for (int panel = 0; panel < PanelsPerSegment; ++panel)
    {
      float enter = segment.enter + float(panel) * panelMm;
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
  }
  return sum;
}
