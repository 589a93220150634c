// A plane slice through the volume, blended with the others.

uniform float sliceMm; // length that a slice stands for [mm]
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  fragOutput0 = SampleColor(positionGrid, AwayFromEye(positionGrid), sliceMm);
}
