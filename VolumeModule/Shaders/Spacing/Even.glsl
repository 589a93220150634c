// Voxels are at even places.

vec3 VoxelPlace(vec3 positionTexture)
{
  return positionTexture;
}
