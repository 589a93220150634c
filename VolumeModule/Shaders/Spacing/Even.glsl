// Voxels are evenly spaced.

vec3 VoxelPlace(vec3 positionTexture)
{
  return positionTexture;
}
