// Blinn-Phong with a head light: Blinn, "Models of light reflection for computer synthesized
// pictures" (SIGGRAPH 1977). Light and eye are in one place, so the half vector is the direction
// to the eye. Both sides of a surface are lit. The normal is the gradient; where it vanishes only
// ambient light is left, as in VTK.

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  reflectance.yz *= LitPart(gradient);
  vec3 normal = worldFromGradient * gradient;
  float size = length(normal);
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  float facing = size > 0.0 ? abs(dot(normal, toEye)) / size : 0.0;
  return color * (reflectance.x + reflectance.y * facing * diffuseLight) +
    reflectance.z * pow(facing, reflectance.w) * specularLight;
}
