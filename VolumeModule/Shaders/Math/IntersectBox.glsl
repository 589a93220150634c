// Where a ray enters and leaves a box: (enter, exit), empty when enter >= exit.
// Slab test of Kay and Kajiya (SIGGRAPH 1986).

// Inverse of a direction for divisions by it: a component that is zero, or so small that its
// inverse would overflow, becomes a tiny one.
vec3 SafeInverse(vec3 direction)
{
  vec3 signs = step(vec3(0.0f), direction) * 2.0f - 1.0f;
  return signs / max(abs(direction), vec3(1e-30f));
}

// The slab between two planes of one axis. The position of a ray along the slab is compared: 0 / 0
// must not reach the result when it runs in one of the planes.
// @param inverse  the inverse of the direction, by SafeInverse
vec2 IntersectSlab(float origin, float inverse, float lower, float upper)
{
  float toLower = (lower - origin) * inverse;
  float toUpper = (upper - origin) * inverse;
  float never = origin >= lower && origin <= upper ? 3e38f : -3e38f;
  return vec2(abs(inverse) >= 1e30f ? -never : min(toLower, toUpper),
    abs(inverse) >= 1e30f ? never : max(toLower, toUpper));
}

vec2 IntersectBox(vec3 origin, vec3 inverse, vec3 lower, vec3 upper)
{
  vec2 x = IntersectSlab(origin.x, inverse.x, lower.x, upper.x);
  vec2 y = IntersectSlab(origin.y, inverse.y, lower.y, upper.y);
  vec2 z = IntersectSlab(origin.z, inverse.z, lower.z, upper.z);
  return vec2(max(max(x.x, y.x), z.x), min(min(x.y, y.y), z.y));
}
