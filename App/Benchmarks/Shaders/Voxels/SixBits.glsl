// Five voxels of six bits along z in a word.

uniform usampler3D volumeTexture;

float VoxelAt(ivec3 voxel)
{
  uint word = texelFetch(volumeTexture, ivec3(voxel.xy, voxel.z / 5), 0).r;
  return float((word >> (6 * (voxel.z % 5))) & 63u) / 63.0;
}
