// Maps premultiplied colors from level - window / 2 to level + window / 2 to those from black to
// white.
vec4 WindowedColor(vec4 image, vec2 scaleBias)
{
  float red = clamp(image.x * scaleBias.x + image.w * scaleBias.y, 0.0f, image.w);
  float green = clamp(image.y * scaleBias.x + image.w * scaleBias.y, 0.0f, image.w);
  float blue = clamp(image.z * scaleBias.x + image.w * scaleBias.y, 0.0f, image.w);
  return vec4(red, green, blue, image.w);
}
