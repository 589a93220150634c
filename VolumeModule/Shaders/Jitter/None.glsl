// All rays begin with a whole segment.

float FirstSegment()
{
  return 1.0;
}

float PlainMm(int index, float plainMm)
{
  return plainMm;
}
