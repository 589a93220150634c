// The walk of a ray through the cells of a lattice, whose cell c spans [c, c + 1] on each axis.
// The next cell follows from the face through which the ray leaves, not from where the ray then is,
// as in Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing" (Eurographics 1987):
// each step leads on, however small the direction and whatever the rounding. Needs
// IntersectBox.glsl.

struct LatticeRay
{
  vec3 origin;
  vec3 direction;
  vec3 inverse;
  vec3 outward;  // 1 on axes on which the ray ascends, else -1
  vec3 fromFace; // from the origin to the face through which the ray leaves cell 0
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
  ray.outward = step(vec3(0.0f), direction) * 2.0f - 1.0f;
  ray.fromFace = 0.5f * (ray.outward + 1.0f) - origin;
  return ray;
}

LatticePlace PlaceAt(LatticeRay ray, float t, vec3 cellCount)
{
  LatticePlace place;
  place.cell = clamp(floor(ray.origin + t * ray.direction), vec3(0.0f), cellCount - 1.0f);
  place.t = t;
  return place;
}

// Where the ray leaves a cell, and the cell that it enters.
LatticePlace BehindCell(LatticeRay ray, LatticePlace place)
{
  vec3 exits = (place.cell + ray.fromFace) * ray.inverse;
  float exit = min(min(exits.x, exits.y), exits.z);
  LatticePlace behind;
  behind.t = max(place.t, exit);
  behind.cell = mix(place.cell, place.cell + ray.outward, lessThanEqual(exits, vec3(exit)));
  return behind;
}

// The same for the block of cells c - radius ... c + radius.
LatticePlace BehindBlock(LatticeRay ray, LatticePlace place, float radius)
{
  vec3 farthest = place.cell + radius * ray.outward;
  vec3 exits = (farthest + ray.fromFace) * ray.inverse;
  float exit = min(min(exits.x, exits.y), exits.z);
  LatticePlace behind;
  behind.t = max(place.t, exit);
  // On the other axes the ray is still in the block, even where rounding says that it is not.
  vec3 within =
    clamp(floor(ray.origin + behind.t * ray.direction), place.cell - radius, place.cell + radius);
  behind.cell = mix(within, farthest + ray.outward, lessThanEqual(exits, vec3(exit)));
  return behind;
}
