// A gap is transparent.

Accumulation FillGap(Accumulation sum, float lengthMm)
{
  return sum;
}
