// The loop for shaded volumes. A gradient costs six fetches and a normal can turn round within a
// fraction of a voxel, at the ridge of a thin bone. So scalar and gradient are fetched once for
// each segment, at its end, and taken as linear between; the parts of a segment, with their own
// normal and light, then cost arithmetic only. Where the ray jumps, a segment without length makes
// the scalar behind known.
// An inner loop looks for the next segment that absorbs anything before the gradient is fetched.
// A branch would not do: where pixels are drawn in lockstep both of its sides are paid for, while
// a loop ends for all of them when it has ended for each.

const float PartsPerSegment = 4.0;

// A segment: scalar and gradient go linearly from its start to its end.
struct Linear
{
  float startScalar;
  float endScalar;
  vec3 startGradient;
  vec3 endGradient;
};

uniform vec2 visibleScalars; // only between these does anything absorb

bool IsVisible(float startScalar, float endScalar)
{
  return max(startScalar, endScalar) > visibleScalars.x &&
    min(startScalar, endScalar) < visibleScalars.y;
}

// Takes in a part whose middle is at this place, [0,1], along the segment.
Accumulation BlendLit(Accumulation sum, Linear segment, float along, float partMm, Ray ray)
{
  vec4 optical = Classify(mix(segment.startScalar, segment.endScalar, along));
  vec3 gradient = mix(segment.startGradient, segment.endGradient, along);
  return BlendPart(sum, Shade(optical.rgb, gradient, ray), optical.a * partMm);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  float t = inside.enter;
  float endScalar = ScalarAt(PositionTexture(ray, t));
  vec3 endGradient = vec3(0.0);
  bool known = false; // the gradient at t
  int index = 0;
  while (index < mostSegments && t < inside.exit && !BlendFinished(sum))
  {
    float startScalar;
    float lengthMm;
    do
    {
      Interval segment = NextSegment(ray, inside, t, index, stepMm, BlendState(sum));
      bool jumps = segment.enter > t;
      t = min(jumps ? segment.enter : segment.exit, inside.exit);
      lengthMm = jumps ? 0.0 : max(t - segment.enter, 0.0);
      startScalar = endScalar;
      endScalar = ScalarAt(PositionTexture(ray, t));
      ++index;
      if (lengthMm > 0.0 && IsVisible(startScalar, endScalar))
      {
        break;
      }
      known = false;
    } while (t < inside.exit && index < mostSegments);

    vec3 gradient = GradientAt(PositionTexture(ray, t));
    // Before the first visible segment there is no gradient yet; there it absorbs least.
    Linear segment = Linear(startScalar, endScalar, known ? endGradient : gradient, gradient);
    endGradient = gradient;
    known = true;
    // Not a loop: the arithmetic of the four is then one block.
    float partMm = lengthMm / PartsPerSegment;
    sum = BlendLit(sum, segment, 0.125, partMm, ray);
    sum = BlendLit(sum, segment, 0.375, partMm, ray);
    sum = BlendLit(sum, segment, 0.625, partMm, ray);
    sum = BlendLit(sum, segment, 0.875, partMm, ray);
  }
  return sum;
}
