// The loop for materials that depend on gradients or on several values. A gradient costs six
// fetches and a normal can turn round within a fraction of a voxel, at the ridge of a thin bone. So
// values and gradients are fetched once for each segment, at its end, and taken as linear between;
// the parts of a segment, with their own normal and light, then cost arithmetic only. Where the ray
// jumps, a segment without length makes the values behind known.
// An inner loop looks for the next segment that absorbs anything before the gradient is fetched.
// A branch would not do: where pixels are drawn in lockstep both of its sides are paid for, while
// a loop ends for all of them when it has ended for each.

const float PartsPerSegment = 4.0;

// A segment: values and gradients go linearly from its start to its end.
struct Linear
{
  Values startValues;
  Values endValues;
  Gradients startGradients;
  Gradients endGradients;
  float enter;
  float lengthMm;
};

// Takes in a part whose middle is at this place, [0,1], along the segment.
Accumulation BlendMaterial(Accumulation sum, Linear segment, float along, Ray ray)
{
  vec4 optical = Material(Between(segment.startValues, segment.endValues, along),
    Between(segment.startGradients, segment.endGradients, along), ray,
    segment.enter + along * segment.lengthMm);
  return BlendPart(sum, optical.rgb, optical.a * (segment.lengthMm / PartsPerSegment));
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  Values endValues = ValuesAt(PositionTexture(ray, t));
  Gradients endGradients;
  bool known = false; // the gradients at t
  int index = 0;
  while (index < mostSegments && t < inside.exit && !BlendFinished(sum))
  {
    Values startValues;
    float lengthMm;
    bool absorbs;
    do
    {
      Interval segment = NextSegment(ray, inside, t, index, stepMm, BlendState(sum));
      bool jumps = segment.enter > t;
      t = min(jumps ? segment.enter : segment.exit, inside.exit);
      lengthMm = jumps ? 0.0 : max(t - segment.enter, 0.0);
      startValues = endValues;
      endValues = ValuesAt(PositionTexture(ray, t));
      index += jumps ? 0 : 1; // the first segment is the first that is marched
      absorbs = lengthMm > 0.0 && MayAbsorb(startValues, endValues);
      if (absorbs)
      {
        break;
      }
      known = false;
    } while (t < inside.exit && index < mostSegments);
    if (!absorbs)
    {
      break; // all that was left is invisible
    }

    Gradients gradients = GradientsAt(PositionTexture(ray, t));
    // Before the first visible segment there is no gradient yet; there it absorbs least.
    if (!known)
    {
      endGradients = gradients;
    }
    Linear segment =
      Linear(startValues, endValues, endGradients, gradients, t - lengthMm, lengthMm);
    endGradients = gradients;
    known = true;
    // Not a loop: the arithmetic of the four is then one block.
    sum = BlendMaterial(sum, segment, 0.125, ray);
    sum = BlendMaterial(sum, segment, 0.375, ray);
    sum = BlendMaterial(sum, segment, 0.625, ray);
    sum = BlendMaterial(sum, segment, 0.875, ray);
  }
  return sum;
}
