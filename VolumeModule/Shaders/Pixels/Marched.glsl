// What the processor has marched: colours, or places. viewportOriginPixels is of the pixels that
// were marched.

uniform samplerBuffer marchedTexture; // row by row, one picture behind the other
uniform int marchedColumns;
uniform int marchedPixels; // of a picture

vec4 MarchedColor(int picture)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  int index = picture * marchedPixels + pixel.y * marchedColumns + pixel.x;
  return texelFetch(marchedTexture, index);
}
