// Multiplies the framebuffer by the factors that the processor has computed for its pixels.

out vec4 fragOutput0;

void main()
{
  fragOutput0 = MarchedColor(0);
}
