#include "Math/StepGrowth.glsl"
// The loop for several overlapping volumes. It marches all of them together, from face to face of
// their boxes, and skips parts in which no volume is visible. In a segment the values of each
// volume are linear or constant (slot Reading), so that the parts of a segment cost arithmetic
// only. An inner loop finds the next segment in which any volume absorbs light (see
// MaterialSegments.glsl). The loop is tested at its top; otherwise llvmpipe (Mesa 22.3) gives a ray
// that has left it the values that it computes later for the rays drawn in lockstep.

const float PartsPerSegment = 4.0;

Accumulation BlendMixture(Accumulation sum, vec4 mixture, float partMm)
{
  return BlendPart(sum, mixture.rgb / max(mixture.a, 1e-30), mixture.a * partMm);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  Interval volumes = BeginVolumes(ray, inside);
  float t = volumes.enter;
  float readT = -Never;
  int index = 0;
  while (index < mostSegments && t < volumes.exit && !BlendFinished(sum))
  {
    Interval segment = Interval(t, t);
    bool anything = false;
    while (!anything && t < volumes.exit && index < mostSegments)
    {
      float state = BlendState(sum);
      Interval visible = NextVisible(t, index, state);
      float enter = min(visible.enter, volumes.exit);
      float plain = enter + StepGrowth(state) * PlainMm(index, stepMm);
      float exit = min(max(plain, visible.exit), min(NextFace(enter), volumes.exit));
      // Where the ray jumps, a segment without length reads the values behind the jump.
      bool jumps = enter > readT;
      segment = Interval(enter, jumps ? enter : exit);
      anything = ReadSegment(segment);
      t = segment.exit;
      readT = t;
      index += jumps ? 0 : 1;
    }

    Mixture mixture = MixtureOf(segment);
    float partMm = (segment.exit - segment.enter) / PartsPerSegment;
    sum = BlendMixture(sum, mixture.first, partMm);
    sum = BlendMixture(sum, mixture.second, partMm);
    sum = BlendMixture(sum, mixture.third, partMm);
    sum = BlendMixture(sum, mixture.fourth, partMm);
  }
  return sum;
}
