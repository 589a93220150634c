// Half the difference of the scalars one voxel to either side would be the gradient; this is the
// difference. It vanishes where it is made of a voxel that is not finite.

vec3 GradientAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelCountInverse.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelCountInverse.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelCountInverse.z);
  vec3 gradient = vec3(ScalarAt(positionTexture + x) - ScalarAt(positionTexture - x),
    ScalarAt(positionTexture + y) - ScalarAt(positionTexture - y),
    ScalarAt(positionTexture + z) - ScalarAt(positionTexture - z));
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}
