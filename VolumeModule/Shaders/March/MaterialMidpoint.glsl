// The loop for materials that depend on gradients or on several values, by midpoints: a segment is
// as its middle is, with the normal and the light there. Noise that falls between two samples is
// read elsewhere as often, so that it averages out; what is linear between two samples
// (MaterialSegments.glsl, which tells of the inner loop) leaves it out everywhere.

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
      break; // all that was left is invisible
    }
    vec4 optical = Material(values, GradientsAt(PositionTexture(ray, middle)), ray, middle);
    sum = BlendPart(sum, optical.rgb, optical.a * lengthMm);
  }
  return sum;
}
