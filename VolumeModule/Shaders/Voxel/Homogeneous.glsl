// A voxel is a homogeneous piece of the ray.

Accumulation BlendVoxel(Accumulation sum, vec3 middleTexture, Ray ray, float lengthMm)
{
  vec4 optical = Classify(ScalarAt(middleTexture));
  return BlendPart(sum, optical.rgb, optical.a * lengthMm);
}
