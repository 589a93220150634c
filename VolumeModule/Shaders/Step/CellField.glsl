#include "Math/IntersectBox.glsl"
// Steps as long as the cell field allows: to the exit of the block in which the scalar stays
// within the tolerance, but no shorter than plain steps. The field's texel of cell c is 0 if the
// cell itself varies too much, else k + 1 if the block of cells c - k to c + k does not.

Interval NextOfField(Ray ray, Interval inside, float t, float plainMm)
{
  float plain = t + plainMm;
  vec3 origin = ray.originGrid - firstVoxelGrid;
  vec3 position = origin + t * ray.directionGrid;
  vec3 cell = clamp(floor(position), vec3(0.0), fieldSize - 1.0);
  float reach = textureLod(fieldTexture, (cell + 0.5) * fieldSizeInverse, 0.0).r * 255.0;

  // The planes through which the ray leaves the block, one on each axis.
  vec3 ahead = step(vec3(0.0), ray.directionGrid);
  vec3 leaving = cell + ahead + (2.0 * ahead - 1.0) * (floor(reach + 0.5) - 1.0);
  vec3 exits = (leaving - origin) * SafeInverse(ray.directionGrid);
  float proven = min(min(exits.x, exits.y), exits.z);
  return Interval(t, reach < 0.5 ? plain : max(plain, proven));
}

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  return NextOfField(ray, inside, t, PlainMm(index, plainMm));
}
