#include "Math/IntersectBox.glsl"
#include "Math/LatticeWalk.glsl"
// Voxels without interpolation (see Voxels.glsl), for materials that depend on gradients or on
// several values. A voxel has one gradient, that in its middle. An inner loop finds the next voxel
// that absorbs light, before its gradient is fetched (see MaterialSegments.glsl).

float CellsBeforeFirstVoxel()
{
  return 0.5;
}

vec3 CellCount()
{
  return voxelCount;
}

void BeginCells(Ray ray) {}

Accumulation TakeCells(Accumulation sum, Ray ray, float end, float exit)
{
  while (cell.t < end && !BlendFinished(sum))
  {
    Values values;
    vec3 middleTexture;
    Interval part;
    do
    {
      LatticePlace behind = BehindCell(cellRay, cell);
      middleTexture = (cell.cell + 0.5) / voxelCount;
      part = Interval(cell.t, min(behind.t, exit));
      values = ValuesAt(middleTexture);
      cell = behind;
    } while (cell.t < end && !MayAbsorb(values, values));

    float lengthMm = part.exit - part.enter;
    Gradients gradients = GradientsAt(middleTexture);
    vec4 kept = KeptOf(values, gradients, middleTexture * voxelCount - 0.5 + firstVoxelGrid);
    vec4 optical = Material(values, gradients, kept, ray, part.enter + 0.5 * lengthMm);
    sum = BlendPart(sum, optical.rgb, optical.a * lengthMm);
  }
  return sum;
}
