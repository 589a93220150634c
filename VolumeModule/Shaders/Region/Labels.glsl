// All voxels are drawn, by the row of their label in the tables.

bool EntersRegion(float content)
{
  labelRow = int(content);
  return true;
}
