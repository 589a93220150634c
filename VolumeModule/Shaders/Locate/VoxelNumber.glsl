// The number of the point or cell at the position, as a colour of 24 bits.

vec4 ColorOfPlace(vec3 positionGrid)
{
  vec3 place = floor(positionGrid + pickedOffset);
  uvec3 picked = uvec3(clamp(place, vec3(0.0), pickedCount - 1.0));
  uvec3 count = uvec3(pickedCount);
  uint number = (picked.z * count.y + picked.y) * count.x + picked.x;
  number = pickedHighestBits == 1 ? number >> 24 : number & 0xffffffu;
  return vec4(uvec4(number, number >> 8, number >> 16, 255u) & 255u) / 255.0;
}
