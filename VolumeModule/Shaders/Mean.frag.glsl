// No rays: the mean of pictures that have been added up.

uniform vec2 viewportOriginPixels;
uniform sampler2D sumTexture;
uniform float pictureCount; // of those that are whole
uniform int rowsOfNext;     // of one more, from below

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  float count = pictureCount + (pixel.y < rowsOfNext ? 1.0 : 0.0);
  // What no picture has reached yet shows the coarse one.
  fragOutput0 = texelFetch(sumTexture, pixel, 0) / max(count, 1.0);
}
