// Images of all pixels only, whose steps no trial finds.

vec2 RayPixel()
{
  return gl_FragCoord.xy - viewportOriginPixels;
}
