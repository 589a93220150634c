// The filter of the device. It rounds the weights of places that are whole voxels apart alike,
// so that differences between them are those of places nearby, for weights of 8 bits less than
// 1/500 of a voxel away. Too far for opacity where it changes suddenly; near enough for light.

vec4 FilteredForDifference(sampler3D volume, vec3 place)
{
  return textureLod(volume, place, 0.0);
}
