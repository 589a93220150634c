// What has no value is transparent.

Accumulation FillGap(Accumulation sum, float lengthMm)
{
  return sum;
}
