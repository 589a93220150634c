// No rays: the mean of pictures that have been added up.

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  float count = imageCount + (pixel.y < rowsOfNext ? 1.0 : 0.0);
  // What no picture has reached yet shows the coarse one.
  fragOutput0 = texelFetch(sumTexture, pixel, 0) / max(count, 1.0);
}
