// The faces of the volume's box; the fragments they cover are the pixels whose rays can meet it.

in vec3 vertexGrid;

uniform mat4 clipFromGrid;

// Uniforms of the fragment shader are declared here.

void main()
{
  gl_Position = clipFromGrid * vec4(vertexGrid, 1.0);
  // And handed on here.
}
