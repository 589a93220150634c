// There is nothing but the volume itself, as far as its clipping planes leave it.

float DepthAround(Ray ray, ShadowMarch march)
{
  return DepthOf(ray, Clipped(ray, InOwnBox(ray, march.farMm)), march);
}
