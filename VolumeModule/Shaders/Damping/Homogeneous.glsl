// Where a material is homogeneous its gradient is noise, and so is the light on it: the less of it
// the smaller the gradient is.

float LitPart(vec3 gradient)
{
  return min(length(dampingFactors * gradient), 1.0);
}
