// The colour, premultiplied, and the opacity of a sample that stands for a length of its ray.

vec4 SampleColor(vec3 positionGrid, vec3 directionGrid, float lengthMm)
{
  vec3 positionTexture = TextureOfGrid(positionGrid);
  vec4 optical = Classify(ScalarAt(positionTexture));
  if (optical.a <= 0.0)
  {
    return vec4(0.0);
  }
  float absorbed = Absorbed(optical.a, lengthMm);
  Ray ray = Ray(positionGrid, directionGrid, positionTexture, directionGrid * voxelCountInverse);
  return vec4(LitColor(optical.rgb, Arriving(ray), positionTexture, ray) * absorbed, absorbed);
}
