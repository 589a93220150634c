// The scalars at four points of the ray, the first at this t, the others each apartMm farther.
// Where a fetch of the volume is a call, as in software rasterisers, several fetches in a row, and
// what is made of them afterwards, cost less than each with its own arithmetic in a loop.
vec4 ScalarsOfFour(Ray ray, float firstT, float apartMm)
{
  return vec4(ScalarAt(PositionTexture(ray, firstT)),
    ScalarAt(PositionTexture(ray, firstT + apartMm)),
    ScalarAt(PositionTexture(ray, firstT + 2.0 * apartMm)),
    ScalarAt(PositionTexture(ray, firstT + 3.0 * apartMm)));
}
