// Voxels at uneven places along an axis, as in a rectilinear grid. An axis is divided into bins so
// short that the spacing changes at most once in each, so one piece of a table answers for a place.

// The bin of a place in the even grid; the first or last one for a place beyond them.
float SpacingBin(float placeGrid, float lowerGrid, float binsPerGrid, float firstBin, float lastBin)
{
  return clamp(firstBin + floor((placeGrid - lowerGrid) * binsPerGrid), firstBin, lastBin);
}

// The place among the voxels of a place in the even grid.
// @param piece  (where the spacing changes in the even grid, the same among the voxels, voxels per
//               grid unit before it, and behind it)
float UnevenPlace(float placeGrid, vec4 piece)
{
  float beyond = placeGrid - piece.x;
  return piece.y + beyond * (beyond < 0.0f ? piece.z : piece.w);
}
