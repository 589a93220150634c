// One block of several: each ray goes on from what it has gathered in the blocks in front. What is
// drawn is what it has gathered then.

vec4 DrawnRay(Ray ray, Interval inside)
{
  // A ray that runs in the common face of two blocks is marched in one of them.
  bvec3 inFace = equal(ray.originGrid, sharedUpperGrid);
  bvec3 along = lessThan(abs(ray.directionGrid), vec3(1e-30));
  bool another = (inFace.x && along.x) || (inFace.y && along.y) || (inFace.z && along.z);
  inside.exit = another ? inside.enter : inside.exit;

  Accumulation sum = BlendResumed(texelFetch(gatheredTexture, ivec2(gl_FragCoord.xy), 0));
  return BlendKept(MarchCropped(ray, inside, sum));
}
