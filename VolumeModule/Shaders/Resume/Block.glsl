// Marches one of several blocks: each ray continues from its state behind the blocks in front, and
// its new state is drawn.

vec4 DrawnRay(Ray ray, Interval inside)
{
  // A ray in the common face of two blocks is marched in one of them only.
  bvec3 inFace = equal(ray.originGrid, sharedUpperGrid);
  bvec3 along = lessThan(abs(ray.directionGrid), vec3(1e-30));
  bool another = (inFace.x && along.x) || (inFace.y && along.y) || (inFace.z && along.z);
  inside.exit = another ? inside.enter : inside.exit;

  Accumulation sum = BlendResumed(texelFetch(gatheredTexture, ivec2(gl_FragCoord.xy), 0));
  return BlendKept(MarchCropped(ray, inside, sum));
}
