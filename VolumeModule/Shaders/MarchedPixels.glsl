// The images that the processor has marched. Their pixels hold colours, or positions and whether
// there is one. viewportOriginPixels is the origin of their pixels.

vec4 MarchedColor(int picture)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  int index = picture * marchedPixels + pixel.y * marchedColumns + pixel.x;
  return texelFetch(marchedTexture, index);
}
