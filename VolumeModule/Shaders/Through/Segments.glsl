#include "Math/ShadowSteps.glsl"
// Rays go through the same field as the rays of the eye, by the linear rule of
// March/MaterialSegments.glsl. What is near decides, so that segments begin short and grow.

const float PartsOfShadow = 4.0;

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

float DepthAlong(Ray ray, Interval inside, ShadowMarch march)
{
  float t = inside.enter;
  float depth = 0.0;
  float plainMm = march.firstMm;
  Values endValues = ValuesAt(PositionTexture(ray, t));
  for (int index = 0; index < mostSegments && t < inside.exit && depth < march.mostDepth; ++index)
  {
    Interval segment = NextOfField(ray, inside, t, plainMm);
    // Where the ray jumps, a segment without length reads the values behind the jump.
    bool jumps = segment.enter > t;
    t = min(jumps ? segment.enter : segment.exit, inside.exit);
    float lengthMm = jumps ? 0.0 : max(t - segment.enter, 0.0);
    Values startValues = endValues;
    vec3 endTexture = PositionTexture(ray, t);
    endValues = ValuesAt(endTexture);
    if (lengthMm > 0.0 && MayAbsorb(startValues, endValues) && IsSeen(ray, t - 0.5 * lengthMm))
    {
      depth += SegmentDepth(startValues, endValues, endTexture, lengthMm);
    }
    plainMm = jumps ? plainMm : NextShadowStep(plainMm, march.longestMm);
  }
  return depth;
}
