// Values between voxels that no texture can filter: eight voxels are read for each.

uniform vec3 voxelCount;

float ScalarAt(vec3 positionTexture)
{
  vec3 place = clamp(positionTexture * voxelCount - 0.5, vec3(0.0), voxelCount - 1.0);
  ivec3 n = ivec3(place);
  ivec3 f = min(n + 1, ivec3(voxelCount) - 1);
  vec3 part = place - vec3(n);
  float nearNear = mix(VoxelAt(n), VoxelAt(ivec3(f.x, n.yz)), part.x);
  float farNear = mix(VoxelAt(ivec3(n.x, f.y, n.z)), VoxelAt(ivec3(f.xy, n.z)), part.x);
  float nearFar = mix(VoxelAt(ivec3(n.xy, f.z)), VoxelAt(ivec3(f.x, n.y, f.z)), part.x);
  float farFar = mix(VoxelAt(ivec3(n.x, f.yz)), VoxelAt(f), part.x);
  return mix(mix(nearNear, farNear, part.y), mix(nearFar, farFar, part.y), part.z);
}
