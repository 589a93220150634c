// The optical depth of all volumes from the origin of a ray on, as far as the clipping planes leave
// them, which are in the grid of the first volume.

float DepthOfAll(vec3 originWorld, vec3 directionWorld, ShadowMarch march)
{
  Ray ray =
    RayFrom(gridFromWorld * (originWorld - worldOfGridOrigin), gridFromWorld * directionWorld);
  Interval uncut = Clipped(ray, Interval(0.0, march.farMm));
  if (!(uncut.enter < uncut.exit))
  {
    return 0.0;
  }
  march.farMm = uncut.exit - uncut.enter;
  return DepthOfVolumes(originWorld + uncut.enter * directionWorld, directionWorld, march);
}
