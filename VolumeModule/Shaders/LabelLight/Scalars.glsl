// The gradient of the scalars lights voxels with labels too, as in VTK.

vec3 LitLabel(vec3 color, vec3 gradient, Ray ray, float t)
{
  return Shade(color, gradient, reflectances[0], ray, t);
}
