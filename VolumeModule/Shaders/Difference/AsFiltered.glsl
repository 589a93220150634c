// The filter of all other values.

vec4 FilteredForDifference(sampler3D volume, vec3 place)
{
  return Filtered(volume, place);
}
