// As all values are filtered.

vec4 FilteredForDifference(sampler3D volume, vec3 place)
{
  return Filtered(volume, place);
}
