// The lengths of the segments of a ray to a light. What is near decides, so that they begin short.

const int MostShadows = 8;      // lights beyond these cast none
const int MostShadowDepth = 12; // optical depth beyond which no light is left

// The first segment, for the longest one.
float FirstShadowStep(float longestMm)
{
  return 0.125f * longestMm;
}

// The segment after another one.
float NextShadowStep(float lastMm, float longestMm)
{
  return min(1.3f * lastMm, longestMm);
}
