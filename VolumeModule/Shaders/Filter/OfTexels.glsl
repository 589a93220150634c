// The mean of the eight texels around the place, with weights as exact as the place itself.

// Unlike mix(), it returns the texel where both are the same: a rounded mean would have a gradient.
vec4 Between(vec4 a, vec4 b, float weight)
{
  return a + weight * (b - a);
}

vec4 Filtered(sampler3D volume, vec3 place)
{
  ivec3 size = textureSize(volume, 0);
  vec3 texel = place * vec3(size) - 0.5;
  vec3 lower = floor(texel);
  vec3 weight = texel - lower;
  ivec3 n = clamp(ivec3(lower), ivec3(0), size - 1);
  ivec3 f = clamp(ivec3(lower) + 1, ivec3(0), size - 1);
  vec4 nearNear =
    Between(texelFetch(volume, n, 0), texelFetch(volume, ivec3(f.x, n.yz), 0), weight.x);
  vec4 farNear = Between(
    texelFetch(volume, ivec3(n.x, f.y, n.z), 0), texelFetch(volume, ivec3(f.xy, n.z), 0), weight.x);
  vec4 nearFar = Between(
    texelFetch(volume, ivec3(n.xy, f.z), 0), texelFetch(volume, ivec3(f.x, n.y, f.z), 0), weight.x);
  vec4 farFar =
    Between(texelFetch(volume, ivec3(n.x, f.yz), 0), texelFetch(volume, f, 0), weight.x);
  return Between(
    Between(nearNear, farNear, weight.y), Between(nearFar, farFar, weight.y), weight.z);
}
