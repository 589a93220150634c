// Draws rays that the processor has marched in front of layers of translucent geometry, and behind
// others.

out vec4 fragOutput0;

void main()
{
  fragOutput0 = Peeled(Windowed(MarchedColor(0)), Windowed(MarchedColor(1)));
}
