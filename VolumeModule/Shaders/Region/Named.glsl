// Only voxels that the mask names are drawn.

bool EntersRegion(float content)
{
  return content > 0.5;
}
