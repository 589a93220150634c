// The faces of the volume's box. The fragments that they cover are the pixels whose rays can meet
// it.

in vec3 vertexGrid;

void main()
{
  gl_Position = clipFromGrid * vec4(vertexGrid, 1.0);
  PassParameters();
}
