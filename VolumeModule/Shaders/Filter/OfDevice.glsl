// The filter of the device. Graphics cards round its weights, most of them to parts of 2^-8.

vec4 Filtered(sampler3D volume, vec3 place)
{
  return textureLod(volume, place, 0.0);
}
