// Rays begin with a part of a segment, by a noise that neighbours hardly share: what equal steps
// make of a surface, rings like those of wood, becomes a fine grain. It stays where it is from
// picture to picture.

float FirstSegment()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  return texelFetch(noiseTexture, pixel & noisePixelsMask, 0).r;
}

float PlainMm(int index, float plainMm)
{
  return index == 0 ? FirstSegment() * plainMm : plainMm;
}
