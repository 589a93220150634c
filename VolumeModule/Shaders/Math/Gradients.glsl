// Functions of a gradient: the difference of scalars over two voxels along each axis.

// The index in a table over the gradient's magnitude. VTK's magnitude is in units of the data per
// mean spacing of the voxels. Beyond the table its last entry holds.
float GradientIndex(vec3 gradient, vec3 spacingFactors, float indexPerGradient, float lastIndex)
{
  return min(length(spacingFactors * gradient) * indexPerGradient, lastIndex);
}

// The part of the light that a surface receives. In a homogeneous material the gradient is noise,
// and so is the light: the smaller the gradient, the less of it.
float DampedPart(vec3 gradient, vec3 dampingFactors)
{
  return min(length(dampingFactors * gradient), 1.0f);
}
