// Where a material is homogeneous its gradient is noise, and so is the light on it: the less of it
// the smaller the gradient is.

uniform vec3 dampingFactors; // a gradient in texels -> in parts of that at which light is whole

float LitPart(vec3 gradient)
{
  return min(length(dampingFactors * gradient), 1.0);
}
