// There are no planes but those of the volume's box.

Interval Clipped(Ray ray, Interval inside)
{
  return inside;
}
