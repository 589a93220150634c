// Linear rule for materials that depend on gradients or on several values. A gradient costs six
// fetches, and a normal can turn round within a fraction of a voxel, as at the ridge of a thin
// bone. So values and gradients are fetched once for each segment, at its end, and are linear in
// between. A segment is divided into parts, each with its own normal and light, which cost
// arithmetic only. Where the ray jumps, a segment without length fetches the values behind the
// jump.
//
// An inner loop finds the next segment that absorbs light, before its gradient is fetched. A branch
// would save nothing: pixels are drawn in lockstep and pay for both sides of it. A loop ends for
// all pixels when it has ended for each.

const float PartsPerSegment = 4.0;

// A segment along which values, gradients and the light that is kept change linearly.
struct Linear
{
  Values startValues;
  Values endValues;
  Gradients startGradients;
  Gradients endGradients;
  vec4 startKept;
  vec4 endKept;
  float enter;
  float lengthMm;
};

// Adds the part of a segment whose middle is at this fraction of its length, [0,1].
Accumulation BlendMaterial(Accumulation sum, Linear segment, float along, Ray ray)
{
  vec4 optical = Material(Between(segment.startValues, segment.endValues, along),
    Between(segment.startGradients, segment.endGradients, along),
    mix(segment.startKept, segment.endKept, along), ray, segment.enter + along * segment.lengthMm);
  return BlendPart(sum, optical.rgb, optical.a * (segment.lengthMm / PartsPerSegment));
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  Values endValues = ValuesAt(PositionTexture(ray, t));
  Gradients endGradients;
  vec4 endKept;
  bool known = false; // true if endGradients and endKept are those at t
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
      index += jumps ? 0 : 1; // the first segment that is marched is number 0
      absorbs = lengthMm > 0.0 && MayAbsorb(startValues, endValues);
      if (absorbs)
      {
        break;
      }
      known = false;
    } while (t < inside.exit && index < mostSegments);
    if (!absorbs)
    {
      break; // the rest of the ray is invisible
    }

    Gradients gradients = GradientsAt(PositionTexture(ray, t));
    vec4 kept = KeptAt(ray, t);
    // The gradient at the beginning of a visible segment behind an invisible one was not fetched.
    // That at its end stands for it, because such a segment absorbs least at its beginning.
    if (!known)
    {
      endGradients = gradients;
      endKept = kept;
    }
    Linear segment = Linear(
      startValues, endValues, endGradients, gradients, endKept, kept, t - lengthMm, lengthMm);
    endGradients = gradients;
    endKept = kept;
    known = true;
    // Without a loop the arithmetic of the four parts is one block.
    sum = BlendMaterial(sum, segment, 0.125, ray);
    sum = BlendMaterial(sum, segment, 0.375, ray);
    sum = BlendMaterial(sum, segment, 0.625, ray);
    sum = BlendMaterial(sum, segment, 0.875, ray);
  }
  return sum;
}
