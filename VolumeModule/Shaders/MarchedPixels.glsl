// The image that the processor has marched: colours, or places and whether there is one.
// viewportOriginPixels is that of its pixels.

vec4 MarchedColor(int picture)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  int index = picture * marchedPixels + pixel.y * marchedColumns + pixel.x;
  return texelFetch(marchedTexture, index);
}
