// No rays: the mean of pictures that have been added up.

uniform vec2 viewportOriginPixels;
uniform sampler2D sumTexture;
uniform float pictureCount;

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  fragOutput0 = texelFetch(sumTexture, pixel, 0) / pictureCount;
}
