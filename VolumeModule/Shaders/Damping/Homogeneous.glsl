#include "Math/Gradients.glsl"
// Light fades where the gradient is small.

float LitPart(vec3 gradient)
{
  return DampedPart(gradient, dampingFactors);
}
