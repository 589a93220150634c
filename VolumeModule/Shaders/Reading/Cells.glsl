// A volume that is interpolated between its voxels: values and gradients are read at the end of
// each segment and are linear in between, as in March/MaterialSegments.glsl.

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

vec4 KeptIn(Ray ray, Interval segment)
{
  return KeptAt(ray, 0.5 * (segment.enter + segment.exit));
}

void ReadGradients(Ray ray, Interval segment, bool isNext)
{
  Gradients gradients = GradientsAt(PositionTexture(ray, segment.exit));
  startGradients = endGradients;
  // The gradient at the beginning of a visible segment behind an invisible one was not read. That
  // at its end stands for it, because such a segment absorbs least at its beginning.
  if (!isNext)
  {
    startGradients = gradients;
  }
  endGradients = gradients;
}
