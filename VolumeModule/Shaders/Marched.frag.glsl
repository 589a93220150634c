// No rays: those that the processor has marched.

uniform vec2 viewportOriginPixels;    // of the pixels that were marched
uniform samplerBuffer marchedTexture; // row by row
uniform int marchedColumns;

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  fragOutput0 = Windowed(texelFetch(marchedTexture, pixel.y * marchedColumns + pixel.x));
}
