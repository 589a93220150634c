#include "Math/CubicSpline.glsl"
// The tricubic spline through the voxels. The texture holds its coefficients
// (Core/Geometry/SplineCoefficients.h). Beyond the outermost voxels the value is that at the face.

// The weighted sum of eight trilinear samples.
vec4 SplineSum(vec3 cell, SplineReadings at)
{
  vec3 n = (cell + 0.5 + at.nearPlace) / voxelCount;
  vec3 f = (cell + 0.5 + at.farPlace) / voxelCount;
  vec4 nearNear = at.nearWeight.x * StoredAt(n) + at.farWeight.x * StoredAt(vec3(f.x, n.yz));
  vec4 farNear =
    at.nearWeight.x * StoredAt(vec3(n.x, f.y, n.z)) + at.farWeight.x * StoredAt(vec3(f.xy, n.z));
  vec4 nearFar =
    at.nearWeight.x * StoredAt(vec3(n.xy, f.z)) + at.farWeight.x * StoredAt(vec3(f.x, n.y, f.z));
  vec4 farFar = at.nearWeight.x * StoredAt(vec3(n.x, f.yz)) + at.farWeight.x * StoredAt(f);
  return at.nearWeight.z * (at.nearWeight.y * nearNear + at.farWeight.y * farNear) +
    at.farWeight.z * (at.nearWeight.y * nearFar + at.farWeight.y * farFar);
}

vec3 SplinePlace(vec3 positionTexture)
{
  vec3 place = VoxelPlace(positionTexture) * voxelCount - 0.5;
  return clamp(place, vec3(0.0), voxelCount - 1.0);
}

vec4 TexelAt(vec3 positionTexture)
{
  vec3 place = SplinePlace(positionTexture);
  vec3 cell = floor(place);
  return SplineSum(cell, SplineValue(place - cell));
}

vec4 TexelForDifference(vec3 positionTexture)
{
  return TexelAt(positionTexture);
}

float ScalarAt(vec3 positionTexture)
{
  return TexelAt(positionTexture).r;
}

vec4 SlopeAlong(vec3 axis, vec3 positionTexture)
{
  vec3 place = SplinePlace(positionTexture);
  vec3 cell = floor(place);
  SplineReadings value = SplineValue(place - cell);
  SplineReadings slope = SplineSlope(place - cell);
  return SplineSum(cell,
    SplineReadings(mix(value.nearPlace, slope.nearPlace, axis),
      mix(value.farPlace, slope.farPlace, axis), mix(value.nearWeight, slope.nearWeight, axis),
      mix(value.farWeight, slope.farWeight, axis)));
}
