// Surfaces lie where scalars change.

int SurfaceCount()
{
  return 1;
}

bool HasSurface(int material, Values values, Gradients gradients)
{
  return true;
}

vec3 OwnWayOutside(int material, Values values, Gradients gradients, vec3 positionGrid)
{
  return WayOfScalars(values, gradients);
}
