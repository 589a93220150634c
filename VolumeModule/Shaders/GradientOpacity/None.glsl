// Opacity does not depend on the gradient.

float AtGradient(float extinction, vec3 gradient, int component)
{
  return extinction;
}
