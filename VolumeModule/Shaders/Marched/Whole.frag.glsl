// Draws rays that the processor has marched.

out vec4 fragOutput0;

void main()
{
  fragOutput0 = Windowed(MarchedColor(0));
}
