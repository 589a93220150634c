// Each voxel has a label, which fills the cube around it: the march goes exactly to where another
// label begins. The mask's texel holds (the row of its label in the tables; k + 1 where all voxels
// v - k ... v + k have the same).

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
    // Blocks of one label are joined to one march.
    Interval part = Interval(place.t, place.t);
    labelRow = int(MaskAt(place.cell).x);
    bool same = true;
    while (place.t < inside.exit && same)
    {
      vec2 mask = MaskAt(place.cell);
      same = int(mask.x) == labelRow;
      if (same)
      {
        place = BehindBlock(lattice, place, max(mask.y - 1.0, 0.0));
        part.exit = min(place.t, inside.exit);
      }
    }
    if (part.enter < part.exit)
    {
      sum = MarchVolume(ray, part, sum);
    }
  }
  return sum;
}
