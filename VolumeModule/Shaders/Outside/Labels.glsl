// The surface of a voxel with a label is that of its label, from which the way leads to the side on
// which there is less matter. Inside a label there is no surface, and a place sees what is around
// itself.

float ExtinctionBeside(vec3 positionGrid, Gradients gradients)
{
  int ownRow = labelRow;
  labelRow = max(LabelRowAt(positionGrid), 0);
  vec3 positionTexture = (positionGrid - firstVoxelGrid + 0.5) * voxelCountInverse;
  float extinction = MaterialExtinction(ValuesAt(positionTexture), gradients);
  labelRow = ownRow;
  return extinction;
}

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
  if (labelRow == 0)
  {
    return WayOfScalars(values, gradients);
  }
  vec3 inward = GradientOfLabel(positionGrid);
  if (dot(inward, inward) <= LeastSurface)
  {
    return vec3(0.0);
  }
  vec3 way = WayOutside(inward, 0.0, 1.0);
  return WayOutside(inward, ExtinctionBeside(positionGrid + way, gradients),
    ExtinctionBeside(positionGrid - way, gradients));
}
