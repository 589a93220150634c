// 32 voxels of one bit along z in a word.

uniform usampler3D volumeTexture;

float VoxelAt(ivec3 voxel)
{
  uint word = texelFetch(volumeTexture, ivec3(voxel.xy, voxel.z >> 5), 0).r;
  return float((word >> (voxel.z & 31)) & 1u);
}
