// Of a voxel a projection sees the scalar. One that the ray but touches is not seen: rounding may
// find such a one where a ray begins or ends.

const float ShortestVoxels = 2e-5;

Accumulation BlendVoxel(Accumulation sum, vec3 middleTexture, Ray ray, float lengthMm)
{
  Accumulation seen = BlendScalar(sum, ScalarAt(middleTexture), lengthMm);
  return lengthMm * length(ray.directionGrid) > ShortestVoxels ? seen : sum;
}
