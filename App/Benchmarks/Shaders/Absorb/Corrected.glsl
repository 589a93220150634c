// The table has opacities that the host has corrected for the length of a whole step, as in Volt
// (2009), so that samples need no exponential. A shorter last step counts as a whole one.

float Absorbed(float opacity, float lengthMm)
{
  return opacity;
}
