// Voxels with a label are lit as the surface of their label, whatever the scalars: the normal is
// the gradient of the part of space that the label fills, interpolated linearly between voxels.
// Where all voxels around have the label there is no surface, and the light is that of a dull
// surface that faces the eye. Damping is for gradients of scalars.

// A smaller square of a gradient is rounding.
const float LeastSurface = 1e-6;

// Mask/Voxels.glsl defines it.
vec2 MaskAt(vec3 voxel);

float LabelledPart(vec3 place)
{
  vec3 low = floor(place);
  vec3 part = place - low;
  float filled = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    vec3 side = vec3(float(corner & 1), float((corner >> 1) & 1), float(corner >> 2));
    vec3 weights = mix(1.0 - part, part, side);
    bool hasLabel = int(MaskAt(low + side).x) == labelRow;
    filled += hasLabel ? weights.x * weights.y * weights.z : 0.0;
  }
  return filled;
}

// Per mask voxel. Two voxels on each side of the nearest one count.
vec3 LabelGradient(vec3 place)
{
  if (MaskAt(floor(place + 0.5)).y >= 3.0)
  {
    return vec3(0.0);
  }
  vec3 x = vec3(1.0, 0.0, 0.0);
  vec3 y = vec3(0.0, 1.0, 0.0);
  vec3 z = vec3(0.0, 0.0, 1.0);
  return vec3(LabelledPart(place + x) - LabelledPart(place - x),
    LabelledPart(place + y) - LabelledPart(place - y),
    LabelledPart(place + z) - LabelledPart(place - z));
}

vec3 GradientOfLabel(vec3 positionGrid)
{
  return maskVoxelsPerVoxel * LabelGradient((positionGrid + 0.5) * maskVoxelsPerVoxel - 0.5);
}

vec3 LitLabel(vec3 color, vec3 gradient, Ray ray, float t)
{
  vec4 reflectance = reflectances[0];
  if (labelRow == 0)
  {
    return Shade(color, gradient, reflectance, ray, t);
  }
  vec3 normal = GradientOfLabel(PositionGrid(ray, t));
  if (dot(normal, normal) <= LeastSurface)
  {
    normal = (worldFromGrid * ray.directionGrid) * worldFromGrid; // its transform is the direction
    reflectance.z = 0.0;
  }
  return Shade(color, labelGradient * normal, reflectance, ray, t);
}
