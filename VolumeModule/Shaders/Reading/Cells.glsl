// A volume that is interpolated between its voxels: values and gradients are read where a segment
// ends, and taken as linear in it, as in March/MaterialSegments.glsl.

Values startValues;
Values endValues;
Gradients startGradients;
Gradients endGradients;

void BeginReading(Ray ray, float t) {}

float NextReadingFace(float t)
{
  return Never;
}

void ReadValues(Ray ray, Interval segment)
{
  startValues = endValues;
  endValues = ValuesAt(PositionTexture(ray, segment.exit));
}

void ReadGradients(Ray ray, Interval segment, bool isNext)
{
  Gradients gradients = GradientsAt(PositionTexture(ray, segment.exit));
  startGradients = endGradients;
  // Before the first visible segment there is no gradient yet; there it absorbs least.
  if (!isNext)
  {
    startGradients = gradients;
  }
  endGradients = gradients;
}
