#include "Math/Absorption.glsl"
// Compositing from the back to the front, to compare it with the usual order. A part of a ray gets
// a sum of its own, which is then put behind everything that the ray has gathered, so that the
// slots that divide rays need not know of the order. The segments are those of Step/Fixed.glsl. No
// ray ends early, because anything may follow in front.

// A homogeneous part of the ray over the parts behind it: the operator "over" of Porter and Duff,
// "Compositing digital images" (SIGGRAPH 1984).
Accumulation BlendOver(Accumulation behind, vec3 color, float depth)
{
  float absorbed = Absorption(min(depth, 100.0));
  return Accumulation(mix(behind.color, color, absorbed), behind.transmittance * (1.0 - absorbed));
}

// Everything gathered so far over a part of the ray behind it.
Accumulation BlendBehind(Accumulation front, Accumulation behind)
{
  return Accumulation(
    front.color + front.transmittance * behind.color, front.transmittance * behind.transmittance);
}

// The number of segments of a part of the ray.
int SegmentCount(Interval inside, float segmentMm)
{
  float whole = ceil((inside.exit - inside.enter) / segmentMm - FirstSegment());
  return min(int(whole) + 1, mostSegments);
}

// Segment number `index` of a part of the ray.
Interval SegmentOf(Ray ray, Interval inside, int index, float segmentMm)
{
  float enter = inside.enter;
  if (index > 0)
  {
    enter = NextSegment(ray, inside, enter, index - 1, segmentMm, 1.0).exit;
  }
  float exit = NextSegment(ray, inside, enter, index, segmentMm, 1.0).exit;
  return Interval(min(enter, inside.exit), min(exit, inside.exit));
}
