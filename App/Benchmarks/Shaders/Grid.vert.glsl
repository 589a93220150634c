// Polygons in grid space.

uniform mat4 clipFromGrid;
in vec3 vertexGrid;
out vec3 positionGrid;

void main()
{
  positionGrid = vertexGrid;
  gl_Position = clipFromGrid * vec4(vertexGrid, 1.0);
}
