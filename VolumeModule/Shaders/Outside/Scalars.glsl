// Surfaces lie where scalars change.

vec3 OwnWayOutside(vec3 wayOfScalars, Gradients gradients, vec3 positionGrid)
{
  return wayOfScalars;
}
