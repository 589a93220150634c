#include "Math/UnevenPlace.glsl"
// Voxels are unevenly spaced along each axis: rays are straight in the even grid from the first
// voxel to the last, and the texture has the voxels. Each axis takes one look-up.

float VoxelAlong(float placeGrid, int axis)
{
  float bin = SpacingBin(placeGrid, spacingLowerGrid[axis], spacingBinsPerGrid[axis],
    spacingFirstBins[axis], spacingLastBins[axis]);
  return UnevenPlace(placeGrid, texelFetch(spacingTable, int(bin)));
}

vec3 VoxelPlace(vec3 positionTexture)
{
  vec3 place = positionTexture * spacingVoxelCount - 0.5;
  vec3 voxel = vec3(VoxelAlong(place.x, 0), VoxelAlong(place.y, 1), VoxelAlong(place.z, 2));
  return (voxel + 0.5) / spacingVoxelCount;
}
