// The first segment of each ray is shortened by blue noise, which differs between neighbouring
// pixels. Equal steps would make rings on a surface, like those of wood; the noise turns these into
// fine grain. It is the same in every image.

float FirstSegment()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  return texelFetch(noiseTexture, pixel & noisePixelsMask, 0).r;
}

float PlainMm(int index, float plainMm)
{
  return index == 0 ? FirstSegment() * plainMm : plainMm;
}
