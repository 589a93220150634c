// The midpoint rule of MaterialMidpoint.glsl, from the back to the front. As there, an inner loop
// finds the next segment that absorbs light, before its gradient is fetched.

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  Accumulation behind = BlendBegin();
  int index = SegmentCount(inside, stepMm);
  while (index > 0)
  {
    float middle;
    float lengthMm;
    Values values;
    bool absorbs;
    do
    {
      --index;
      Interval segment = SegmentOf(ray, inside, index, stepMm);
      lengthMm = segment.exit - segment.enter;
      middle = segment.enter + 0.5 * lengthMm;
      values = ValuesAt(PositionTexture(ray, middle));
      absorbs = lengthMm > 0.0 && MayAbsorb(values, values);
      if (absorbs)
      {
        break;
      }
    } while (index > 0);
    if (!absorbs)
    {
      break; // the rest of the ray is invisible
    }
    Gradients gradients = GradientsAt(PositionTexture(ray, middle));
    vec4 kept = KeptOf(values, gradients, PositionGrid(ray, middle));
    vec4 optical = Material(values, gradients, kept, ray, middle);
    behind = BlendOver(behind, optical.rgb, optical.a * lengthMm);
  }
  return BlendBehind(sum, behind);
}
