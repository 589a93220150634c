vec3 LitColor(vec3 color, vec3 positionTexture, Ray ray)
{
  return color;
}
