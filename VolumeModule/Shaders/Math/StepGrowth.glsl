// How much longer a step may be behind what lets only this part of the light through. An error made
// behind a veil is seen through it: a rule of order p spends its samples best where steps grow with
// the power -1 / (p + 1) of the light that is left, which is 1/3 for the rules of order 2.
const float LongestGrowth = 4.0f;

float StepGrowth(float transmittance)
{
  return min(pow(max(transmittance, 1e-6f), -1.0f / 3.0f), LongestGrowth);
}
