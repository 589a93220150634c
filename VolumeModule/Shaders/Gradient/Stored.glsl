// The difference between the scalars one voxel to either side, from a texture that has it for each
// voxel. Interpolated differences of voxels are the differences of interpolated voxels, so this is
// CentralDifferences.glsl but for the rounding of the texture.

vec3 GradientAt(vec3 positionTexture)
{
  CountFetch();
  vec3 gradient = FilteredForDifference(gradientTexture, VoxelPlace(positionTexture)).rgb;
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}
