// Only voxels that a mask names are drawn: each fills the cube around it, and the march goes
// exactly to its faces. The mask's texel holds (whether it is named; k + 1 where all voxels v - k
// ... v + k are as it is).

uniform sampler3D maskTexture; // nearest
uniform vec3 maskVoxelCount;
uniform vec3 maskVoxelsPerVoxel;

vec2 MaskAt(vec3 voxel)
{
  vec3 inside = clamp(voxel, vec3(0.0), maskVoxelCount - 1.0);
  return floor(textureLod(maskTexture, (inside + 0.5) / maskVoxelCount, 0.0).rg * 65535.0 + 0.5);
}

Accumulation MarchMasked(Ray ray, Interval inside, Accumulation sum)
{
  LatticeRay lattice = RayInLattice(
    (ray.originGrid + 0.5) * maskVoxelsPerVoxel, ray.directionGrid * maskVoxelsPerVoxel);
  LatticePlace place = PlaceAt(lattice, inside.enter, maskVoxelCount);
  while (place.t < inside.exit && !BlendFinished(sum))
  {
    // Blocks of one kind are joined to one march.
    Interval part = Interval(place.t, place.t);
    float named = MaskAt(place.cell).x;
    vec2 mask = vec2(named, 0.0);
    while (place.t < inside.exit && mask.x == named)
    {
      mask = MaskAt(place.cell);
      if (mask.x == named)
      {
        place = BehindBlock(lattice, place, max(mask.y - 1.0, 0.0));
        part.exit = min(place.t, inside.exit);
      }
    }
    if (named > 0.5 && part.enter < part.exit)
    {
      sum = MarchVolume(ray, part, sum);
    }
  }
  return sum;
}
