#include "Math/IntersectBox.glsl"
// One of several overlapping volumes, added to the volumes before it in the shader. The ray of a
// pixel is in the grid of the last volume. Each volume has the same ray in its own grid; t, a
// length in the world, is the same position along both.

Ray ownRay;
Interval ownPart; // part of ownRay inside this volume
bool absorbs;     // true if this volume may absorb light in the segment that was read last
float gradientsT; // t at which endGradients were read [mm]

Interval BeginVolumes(Ray ray, Interval inside)
{
  Interval before = BeginVolumesBefore(ray, inside);
  ownRay.originGrid = (ownGridFromRays * vec4(ray.originGrid, 1.0)).xyz;
  ownRay.directionGrid = mat3(ownGridFromRays) * ray.directionGrid;
  ownRay.originTexture = (ownRay.originGrid - firstVoxelGrid + 0.5) * voxelCountInverse;
  ownRay.directionTexture = ownRay.directionGrid * voxelCountInverse;
  vec2 box =
    IntersectBox(ownRay.originGrid, SafeInverse(ownRay.directionGrid), ownLowerGrid, ownUpperGrid);
  ownPart = Interval(max(inside.enter, box.x), min(inside.exit, box.y));
  bool meets = ownPart.enter < ownPart.exit;
  ownPart = Interval(meets ? ownPart.enter : Never, meets ? ownPart.exit : -Never);
  BeginReading(ownRay, ownPart.enter);
  gradientsT = -Never;
  return Interval(min(before.enter, ownPart.enter), max(before.exit, ownPart.exit));
}

float NextFace(float t)
{
  float face = ownPart.enter > t ? ownPart.enter : ownPart.exit;
  if (t >= ownPart.enter && t < ownPart.exit)
  {
    face = min(face, NextReadingFace(t));
  }
  return min(NextFaceBefore(t), face > t ? face : Never);
}

Interval NextVisible(float t, int index, float blendState)
{
  Interval before = NextVisibleBefore(t, index, blendState);
  float from = max(t, ownPart.enter);
  Interval own = Interval(Never, Never);
  if (from < ownPart.exit)
  {
    own = NextSegment(ownRay, ownPart, from, index, 0.0, blendState);
    own.enter = own.enter < ownPart.exit ? own.enter : Never;
  }
  // A volume that becomes visible later ends the part that looks the same.
  float enter = min(before.enter, own.enter);
  return Interval(enter,
    min(
      before.enter > enter ? before.enter : before.exit, own.enter > enter ? own.enter : own.exit));
}

bool ReadSegment(Interval segment)
{
  bool anyBefore = ReadSegmentBefore(segment);
  ReadValues(ownRay, segment);
  absorbs = ownPart.enter <= segment.enter && segment.exit <= ownPart.exit &&
    segment.enter < segment.exit && MayAbsorb(startValues, endValues);
  return anyBefore || absorbs;
}

// Emission and extinction [1/mm] at a fraction of the segment, [0,1], for what materials keep of
// their light.
vec4 EmissionAt(float along, Interval segment, vec4 kept)
{
  if (!absorbs)
  {
    return vec4(0.0);
  }
  vec4 optical =
    Material(Between(startValues, endValues, along), Between(startGradients, endGradients, along),
      kept, ownRay, mix(segment.enter, segment.exit, along));
  return vec4(optical.rgb * optical.a, optical.a);
}

Mixture MixtureOf(Interval segment)
{
  Mixture sum = MixtureOfBefore(segment);
  ReadGradients(ownRay, segment, gradientsT == segment.enter);
  gradientsT = segment.exit;
  vec4 kept = vec4(1.0);
  if (absorbs)
  {
    kept = KeptIn(ownRay, segment);
  }
  sum.first += EmissionAt(0.125, segment, kept);
  sum.second += EmissionAt(0.375, segment, kept);
  sum.third += EmissionAt(0.625, segment, kept);
  sum.fourth += EmissionAt(0.875, segment, kept);
  return sum;
}
