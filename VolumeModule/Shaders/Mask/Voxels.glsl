#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Each voxel of a mask fills the box around it. The march is divided exactly at the faces at which
// the content of the mask changes. The mask's texel holds the content, and k + 1 if the voxels
// v - k to v + k have the same content.

vec2 MaskAt(vec3 voxel)
{
  vec3 inside = clamp(voxel, vec3(0.0), maskVoxelCount - 1.0);
  return floor(textureLod(maskTexture, (inside + 0.5) / maskVoxelCount, 0.0).rg * 65535.0 + 0.5);
}

int LabelRowAt(vec3 positionGrid)
{
  float content = MaskAt(floor((positionGrid + 0.5) * maskVoxelsPerVoxel)).x;
  return content > leastContent ? int(content) : -1;
}

Accumulation MarchMasked(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(
    (ray.originGrid + 0.5) * maskVoxelsPerVoxel, ray.directionGrid * maskVoxelsPerVoxel);
  LatticePlace place = PlaceAt(lattice, inside.enter, maskVoxelCount);
  while (place.t < inside.exit && !BlendFinished(sum))
  {
    // Consecutive blocks of one content are joined into one march.
    Interval part = Interval(place.t, place.t);
    float content = MaskAt(place.cell).x;
    vec2 mask = vec2(content, 0.0);
    while (place.t < inside.exit && mask.x == content)
    {
      mask = MaskAt(place.cell);
      if (mask.x == content)
      {
        place = BehindBlock(lattice, place, max(mask.y - 1.0, 0.0));
        part.exit = min(place.t, inside.exit);
      }
    }
    labelRow = int(content);
    if (content > leastContent && part.enter < part.exit)
    {
      sum = MarchVolume(ray, part, sum);
    }
  }
  return sum;
}
