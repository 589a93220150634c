// Midpoint rule for materials that depend on gradients or on several values: a segment is
// homogeneous, with the values, the normal and the light in its middle. Noise between samples
// averages out, because samples hit it as often as they miss it. The linear rule of
// MaterialSegments.glsl, which explains the inner loop, misses it everywhere.

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  int index = 0;
  while (index < mostSegments && t < inside.exit && !BlendFinished(sum))
  {
    float middle;
    float lengthMm;
    Values values;
    bool absorbs;
    do
    {
      Interval segment = NextSegment(ray, inside, t, index, stepMm, BlendState(sum));
      t = min(segment.exit, inside.exit);
      lengthMm = t - segment.enter;
      middle = segment.enter + 0.5 * lengthMm;
      values = ValuesAt(PositionTexture(ray, middle));
      ++index;
      absorbs = lengthMm > 0.0 && MayAbsorb(values, values);
      if (absorbs)
      {
        break;
      }
    } while (t < inside.exit && index < mostSegments);
    if (!absorbs)
    {
      break; // the rest of the ray is invisible
    }
    vec4 optical =
      Material(values, GradientsAt(PositionTexture(ray, middle)), KeptAt(ray, middle), ray, middle);
    sum = BlendPart(sum, optical.rgb, optical.a * lengthMm);
  }
  return sum;
}
