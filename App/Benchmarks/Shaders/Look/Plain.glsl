vec3 LitColor(vec3 color, float arriving, vec3 positionTexture, Ray ray)
{
  return arriving * color;
}
