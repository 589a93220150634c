// Voxels are at uneven places along each axis, as in a rectilinear grid: rays are straight in the
// even grid from the first to the last, and this is where in the texture a place of it is. An axis
// is cut into bins so short that the spacing changes at most once in each: one look-up an axis.

float VoxelAlong(float placeGrid, float lowerGrid, float binsPerGrid, float firstBin, float lastBin)
{
  float bin = clamp(firstBin + floor((placeGrid - lowerGrid) * binsPerGrid), firstBin, lastBin);
  vec4 piece = texelFetch(spacingTable, int(bin));
  float beyond = placeGrid - piece.x;
  return piece.y + beyond * (beyond < 0.0 ? piece.z : piece.w);
}

vec3 VoxelPlace(vec3 positionTexture)
{
  vec3 place = positionTexture * spacingVoxelCount - 0.5;
  vec3 voxel;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxel[axis] = VoxelAlong(place[axis], spacingLowerGrid[axis], spacingBinsPerGrid[axis],
      spacingFirstBins[axis], spacingLastBins[axis]);
  }
  return (voxel + 0.5) / spacingVoxelCount;
}
