// There are volumes that this one overlaps. Their optical depths add up. A ray is in the world, so
// that each takes it into its own grid.

// The optical depth of this volume and of all volumes before it in the shader.
float DepthOfVolumes(vec3 originWorld, vec3 directionWorld, ShadowMarch march)
{
  float before = DepthOfVolumesBefore(originWorld, directionWorld, march);
  Ray ray =
    RayFrom(gridFromWorld * (originWorld - worldOfGridOrigin), gridFromWorld * directionWorld);
  return before + DepthOf(ray, InOwnBox(ray, march.farMm), march);
}

float DepthAround(Ray ray, ShadowMarch march)
{
  return DepthOfAll(
    worldFromGrid * ray.originGrid + worldOfGridOrigin, worldFromGrid * ray.directionGrid, march);
}
