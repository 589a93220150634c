// A slice as the light sees it: only its opacity, which the buffer of light is multiplied by.

uniform float sliceMm; // length that a slice stands for [mm]
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  fragOutput0 = SampleColor(positionGrid, AwayFromEye(positionGrid), sliceMm).aaaa;
}
