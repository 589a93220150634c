// Rays are marched from where they enter the volume to where they leave it.

Interval Spanned(Ray ray, Interval inside)
{
  return inside;
}
