// How much longer a step may be behind what lets only this part of the light through. An error made
// behind a veil is seen through it, so that steps may grow; by which power, and where that begins:
// Documentation/Decisions/0005.
const float LongestGrowth = 4.0f;

float StepGrowth(float transmittance)
{
  return inversesqrt(clamp(2.0f * transmittance, 1.0f / (LongestGrowth * LongestGrowth), 1.0f));
}
