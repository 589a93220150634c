// Draws the mean of accumulated images, without rays.

out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - viewportOriginPixels);
  float count = imageCount + (pixel.y < rowsOfNext ? 1.0 : 0.0);
  // A pixel that no image has reached yet shows the coarse image.
  fragOutput0 = texelFetch(sumTexture, pixel, 0) / max(count, 1.0);
}
