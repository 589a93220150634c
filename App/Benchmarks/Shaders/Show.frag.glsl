// Draws a finished image into the renderer's framebuffer.

uniform sampler2D gatheredTexture;
uniform vec2 originPixels; // lower left corner of the image in the framebuffer
out vec4 fragOutput0;

void main()
{
  fragOutput0 = texelFetch(gatheredTexture, ivec2(gl_FragCoord.xy - originPixels), 0);
}
