// Selection, as in Resume/PickProp.glsl, by rays that the processor has marched.

out vec4 fragOutput0;

void main()
{
  if (!(MarchedColor(0).a > leastOpacity))
  {
    discard;
  }
  fragOutput0 = vec4(propColor, 1.0);
}
