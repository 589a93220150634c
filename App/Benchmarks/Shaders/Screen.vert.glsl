// A triangle that covers all pixels.

in vec3 vertexGrid;

void main()
{
  gl_Position = vec4(vertexGrid, 1.0);
}
