// Image and depth, as in Resume/PictureAndDepth.glsl, of rays that the processor has marched.

out vec4 fragOutput0;
out vec4 fragOutput1;

void main()
{
  vec4 place = MarchedColor(1);
  fragOutput0 = Windowed(MarchedColor(0));
  fragOutput1 = place.w > 0.0 ? ColorOfPlace(place.xyz) : vec4(0.0);
}
