#include "Math/ShadowSteps.glsl"
// Rays are marched by the linear rule of March/MaterialSegments.glsl. What is near decides, so that
// segments begin short and grow.

const float PartsOfShadow = 4.0;

// A ray up to a place.
struct Passed
{
  float t;
  float depth;
  float plainMm; // next segment
  Values values; // at t
};

Passed PassedNothing(Ray ray, Interval inside, ShadowMarch march)
{
  return Passed(inside.enter, 0.0, march.firstMm, ValuesAt(PositionTexture(ray, inside.enter)));
}

bool GoesOn(Passed passed, Interval inside, ShadowMarch march)
{
  return passed.t < inside.exit && passed.depth < march.mostDepth;
}

float PartDepth(Values start, Values end, Gradients gradients, float along, float lengthMm)
{
  return MaterialExtinction(Between(start, end, along), gradients) * (lengthMm / PartsOfShadow);
}

// The optical depth of a segment along which values are linear.
float SegmentDepth(Values start, Values end, vec3 endTexture, float lengthMm)
{
  Gradients gradients = GradientsAt(endTexture);
  return PartDepth(start, end, gradients, 0.125, lengthMm) +
    PartDepth(start, end, gradients, 0.375, lengthMm) +
    PartDepth(start, end, gradients, 0.625, lengthMm) +
    PartDepth(start, end, gradients, 0.875, lengthMm);
}

// The ray up to the end of a segment. Where it jumps, a segment without length reads the values
// behind the jump.
Passed PassedBy(Passed before, Ray ray, Interval segment, Interval inside, ShadowMarch march)
{
  bool jumps = segment.enter > before.t;
  Passed passed = before;
  passed.t = min(jumps ? segment.enter : segment.exit, inside.exit);
  vec3 endTexture = PositionTexture(ray, passed.t);
  passed.values = ValuesAt(endTexture);
  float lengthMm = jumps ? 0.0 : max(passed.t - segment.enter, 0.0);
  if (lengthMm > 0.0 && MayAbsorb(before.values, passed.values) &&
    IsSeen(ray, passed.t - 0.5 * lengthMm))
  {
    passed.depth += SegmentDepth(before.values, passed.values, endTexture, lengthMm);
  }
  passed.plainMm = jumps ? before.plainMm : NextShadowStep(before.plainMm, march.longestMm);
  return passed;
}

float DepthAlong(Ray ray, Interval inside, ShadowMarch march)
{
  Passed passed = PassedNothing(ray, inside, march);
  for (int index = 0; index < mostSegments && GoesOn(passed, inside, march); ++index)
  {
    Interval segment = NextOfField(ray, inside, passed.t, passed.plainMm);
    passed = PassedBy(passed, ray, segment, inside, march);
  }
  return passed.depth;
}

Passed PassedByNext(Passed before, Ray ray, Interval inside, ShadowMarch march)
{
  return PassedBy(before, ray, Interval(before.t, before.t + before.plainMm), inside, march);
}

float DepthNear(Ray ray, Interval inside, ShadowMarch march)
{
  Passed passed = PassedNothing(ray, inside, march);
  for (int index = 0; index < mostSegments && GoesOn(passed, inside, march); ++index)
  {
    // Behind the end of the ray a segment has no length.
    passed = PassedByNext(passed, ray, inside, march);
    passed = PassedByNext(passed, ray, inside, march);
    passed = PassedByNext(passed, ray, inside, march);
    passed = PassedByNext(passed, ray, inside, march);
  }
  return passed.depth;
}
