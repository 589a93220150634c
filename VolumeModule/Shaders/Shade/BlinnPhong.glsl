// Blinn-Phong with a head light: Blinn, "Models of light reflection for computer synthesized
// pictures" (SIGGRAPH 1977). Light and eye are in one place, so the half vector is the direction
// to the eye. Both sides of a surface are lit. The normal is the gradient by central differences
// one voxel to either side; where it vanishes, or is made of a voxel that is not
// finite, only ambient light is left, as in VTK.

uniform vec3 voxelSizeTexture;
uniform mat3 worldFromGradient; // a gradient per voxel -> a normal in the world, any length
uniform vec3 ambientLight;      // coefficient x light colour
uniform vec3 diffuseLight;
uniform vec3 specularLight;
uniform float specularPower;

vec3 GradientAt(vec3 positionTexture)
{
  vec3 x = vec3(voxelSizeTexture.x, 0.0, 0.0);
  vec3 y = vec3(0.0, voxelSizeTexture.y, 0.0);
  vec3 z = vec3(0.0, 0.0, voxelSizeTexture.z);
  vec3 gradient = vec3(ScalarAt(positionTexture + x) - ScalarAt(positionTexture - x),
    ScalarAt(positionTexture + y) - ScalarAt(positionTexture - y),
    ScalarAt(positionTexture + z) - ScalarAt(positionTexture - z));
  return HasGradient(positionTexture) ? gradient : vec3(0.0);
}

vec3 Shade(vec3 color, vec3 gradient, Ray ray)
{
  vec3 normal = worldFromGradient * gradient;
  float size = length(normal);
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  float facing = size > 0.0 ? abs(dot(normal, toEye)) / size : 0.0;
  return color * (ambientLight + diffuseLight * facing) +
    specularLight * pow(facing, specularPower);
}
