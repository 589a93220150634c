// What the processor has marched: colours, or places. viewportOriginPixels is of the pixels that
// were marched.

vec4 MarchedColor(int picture)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  int index = picture * marchedPixels + pixel.y * marchedColumns + pixel.x;
  return texelFetch(marchedTexture, index);
}
