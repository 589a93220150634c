// Cubic B-splines by linear filtering: Sigg and Hadwiger, "Fast third-order texture filtering" (GPU
// Gems 2, 2005). Of the four coefficients that a value between the second and the third depends on,
// the first two have weights of one sign, and so have the last two: two linear readings on each
// axis, at places between them, stand for all four.

struct SplineReadings
{
  vec3 nearPlace; // from the second coefficient on [voxels]: in [-1, 0]
  vec3 farPlace;  // in [1, 2]
  vec3 nearWeight;
  vec3 farWeight;
};

// For the value at x, [0,1] of the way from the second to the third.
SplineReadings SplineValue(vec3 x)
{
  vec3 y = 1.0f - x;
  vec3 first = y * y * y / 6.0f;
  vec3 last = x * x * x / 6.0f;
  vec3 second = 2.0f / 3.0f - 0.5f * x * x * (2.0f - x);
  vec3 third = 2.0f / 3.0f - 0.5f * y * y * (2.0f - y);
  SplineReadings at;
  at.nearWeight = first + second;
  at.farWeight = third + last;
  at.nearPlace = -first / at.nearWeight;
  at.farPlace = 1.0f + last / at.farWeight;
  return at;
}

// For the derivative there, per voxel. The weights of both readings are never 0.
SplineReadings SplineSlope(vec3 x)
{
  vec3 y = 1.0f - x;
  vec3 weight = 0.5f + x * y;
  SplineReadings at;
  at.nearWeight = -weight;
  at.farWeight = weight;
  at.nearPlace = -0.5f * y * y / weight;
  at.farPlace = 1.0f + 0.5f * x * x / weight;
  return at;
}
