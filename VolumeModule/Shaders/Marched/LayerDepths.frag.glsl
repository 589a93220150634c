// No rays: where the processor is to march them.

out vec4 fragOutput0;

void main()
{
  fragOutput0 = PeeledDepths();
}
