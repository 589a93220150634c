// Writes the depths between which the processor is to march rays.

out vec4 fragOutput0;

void main()
{
  fragOutput0 = PeeledDepths();
}
