// The loop for materials that depend on gradients or on several values, by midpoints (see
// Midpoint.glsl): each part of a segment is as its middle is, with the normal and the light there.
// Noise that falls between two samples is read elsewhere as often, so that it averages out; what is
// linear between two samples (MaterialSegments.glsl) leaves it out everywhere.

const float PartsPerSegment = 4.0;

Accumulation BlendMiddle(Accumulation sum, Ray ray, float t, float partMm)
{
  vec3 positionTexture = PositionTexture(ray, t);
  Values values = ValuesAt(positionTexture);
  // A loop, not a branch: where pixels are drawn in lockstep it ends when none of them goes on,
  // while both sides of a branch are paid for.
  for (bool absorbs = MayAbsorb(values, values); absorbs; absorbs = false)
  {
    vec4 optical = Material(values, GradientsAt(positionTexture), ray, t);
    sum = BlendPart(sum, optical.rgb, optical.a * partMm);
  }
  return sum;
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  for (int index = 0; index < mostSegments && t < inside.exit && !BlendFinished(sum); ++index)
  {
    Interval segment =
      NextSegment(ray, inside, t, index, PartsPerSegment * stepMm, BlendState(sum));
    if (segment.enter >= inside.exit)
    {
      break; // all that is left is invisible
    }
    t = min(segment.exit, inside.exit);
    float partMm = (t - segment.enter) / PartsPerSegment;
    for (float part = 0.5; part < PartsPerSegment; part += 1.0)
    {
      sum = BlendMiddle(sum, ray, segment.enter + part * partMm, partMm);
    }
  }
  return sum;
}
