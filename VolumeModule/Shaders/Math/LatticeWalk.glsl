// The walk of a ray through the cells of a lattice, whose cell c spans [c, c + 1] on each axis.
// Which cell comes next is decided by the face that the ray leaves through, not by where it then
// is, as in Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing" (Eurographics
// 1987): each step leads on, however small the direction and whatever the rounding.

struct LatticeRay
{
  vec3 origin;
  vec3 direction;
  vec3 inverse;
  vec3 ahead; // 1 on axes on which the ray ascends, else 0
};

struct LatticePlace
{
  vec3 cell;
  float t;
};

LatticeRay RayInLattice(vec3 origin, vec3 direction)
{
  LatticeRay ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.inverse = SafeInverse(direction);
  ray.ahead = step(vec3(0.0f), direction);
  return ray;
}

LatticePlace PlaceAt(LatticeRay ray, float t, vec3 cellCount)
{
  LatticePlace place;
  place.cell = clamp(floor(ray.origin + t * ray.direction), vec3(0.0f), cellCount - 1.0f);
  place.t = t;
  return place;
}

// Where the ray leaves the block of cells c - radius ... c + radius, and the cell that it enters.
LatticePlace BehindBlock(LatticeRay ray, LatticePlace place, float radius)
{
  vec3 outward = 2.0f * ray.ahead - 1.0f;
  vec3 exits = (place.cell + ray.ahead + outward * radius - ray.origin) * ray.inverse;
  float exit = min(min(exits.x, exits.y), exits.z);
  LatticePlace behind;
  behind.t = max(place.t, exit);
  // On the other axes the ray is still in the block, even where rounding says that it is not.
  vec3 within =
    clamp(floor(ray.origin + behind.t * ray.direction), place.cell - radius, place.cell + radius);
  vec3 beyond = place.cell + outward * (radius + 1.0f);
  behind.cell = mix(within, beyond, lessThanEqual(exits, vec3(exit)));
  return behind;
}
