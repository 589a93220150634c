// The positions at which rays enter the volume's box.

in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  fragOutput0 = vec4(positionGrid, 1.0);
}
