// The scalars at four positions along the ray: the first at firstT, the others apartMm farther
// each. If a fetch of the volume is a call, as in software rasterisers, several fetches in a row,
// with the arithmetic on all of them afterwards, cost less than a loop.
vec4 ScalarsOfFour(Ray ray, float firstT, float apartMm)
{
  return vec4(ScalarAt(PositionTexture(ray, firstT)),
    ScalarAt(PositionTexture(ray, firstT + apartMm)),
    ScalarAt(PositionTexture(ray, firstT + 2.0 * apartMm)),
    ScalarAt(PositionTexture(ray, firstT + 3.0 * apartMm)));
}
