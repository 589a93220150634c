// Selection, as in Resume/PickVoxel.glsl, at positions that the processor has found.

out vec4 fragOutput0;

void main()
{
  vec4 place = MarchedColor(0);
  if (place.w == 0.0)
  {
    discard;
  }
  fragOutput0 = ColorOfPlace(place.xyz);
}
