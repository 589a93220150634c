// The first cure of Banquero, Ortiz and Rossi, "Realtime volume render en videojuegos" (2016),
// section 3.2, for objects that come and go as the camera moves: fine steps to the first sample
// with an opacity above one half, and from there on a number of samples. Nothing before is drawn.

const float FineStepsPerStep = 8.0;
const float DepthOfHalf = 0.69314718; // optical depth of an opacity of one half

// A ray in several parts, such as those between gaps, has one hit.
bool hasHit = false;
float samplesTaken = 0.0;

// The t of the first hit, or one behind the ray.
float HitFrom(Ray ray, Interval inside)
{
  float t = inside.enter;
  int most = int(FineStepsPerStep) * mostSegments;
  for (int index = 0; index < most && t < inside.exit && !hasHit; ++index)
  {
    float extinction = Classify(ScalarAt(PositionTexture(ray, t))).a;
    hasHit = extinction * opacityUnitDistancesMm.x > DepthOfHalf;
    t += hasHit ? 0.0 : stepMm / FineStepsPerStep;
  }
  return t;
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  Interval behind = Interval(HitFrom(ray, inside), inside.exit);
  float t = behind.enter;
  for (int index = 0; index < mostSegments && t < behind.exit && samplesTaken < samplesAfterHit &&
       !BlendFinished(sum);
       ++index)
  {
    Interval segment = NextSegment(ray, behind, t, index, stepMm, BlendState(sum));
    float lengthMm = max(min(segment.exit, behind.exit) - segment.enter, 0.0);
    vec4 optical = Classify(ScalarAt(PositionTexture(ray, segment.enter)));
    sum = BlendPart(sum, optical.rgb, optical.a * lengthMm);
    samplesTaken += 1.0;
    t = segment.exit;
  }
  return sum;
}
