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

// The weights of the four coefficients that a value depends on.
struct SplineWeights
{
  vec3 first;
  vec3 second;
  vec3 third;
  vec3 last;
};

// For the value at x, [0, 1] of the way from the second to the third.
SplineWeights WeightsOfValue(vec3 x)
{
  vec3 y = 1.0f - x;
  SplineWeights weights;
  weights.first = 0.16666667f * y * y * y;
  weights.second = 0.66666667f - 0.5f * x * x * (2.0f - x);
  weights.third = 0.66666667f - 0.5f * y * y * (2.0f - y);
  weights.last = 0.16666667f * x * x * x;
  return weights;
}

// For the derivative there, per voxel.
SplineWeights WeightsOfSlope(vec3 x)
{
  vec3 y = 1.0f - x;
  SplineWeights weights;
  weights.first = -0.5f * y * y;
  weights.second = x * (1.5f * x - 2.0f);
  weights.third = y * (2.0f - 1.5f * y);
  weights.last = 0.5f * x * x;
  return weights;
}

SplineReadings SplineValue(vec3 x)
{
  SplineWeights weights = WeightsOfValue(x);
  SplineReadings at;
  at.nearWeight = weights.first + weights.second;
  at.farWeight = weights.third + weights.last;
  at.nearPlace = -weights.first / at.nearWeight;
  at.farPlace = 1.0f + weights.last / at.farWeight;
  return at;
}

// The weights of both readings of a derivative are never 0.
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

// A derivative, or 0 if it is no more than the rounding of a value whose weights sum to 1: even
// matter has no surface.
float SlopeBeyondRounding(float value, float slope)
{
  return abs(slope) > 3e-7f * abs(value) ? slope : 0.0f;
}
