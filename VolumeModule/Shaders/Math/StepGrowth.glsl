// The factor by which a step may be longer behind material that lets only this part of the light
// through, from 1 to 4. An error made behind a veil is seen through it, so that steps may grow;
// Documentation/Decisions/0005 derives the power and where it begins.
float StepGrowth(float transmittance)
{
  return inversesqrt(clamp(2.0f * transmittance, 0.0625f, 1.0f));
}
