// Where a ray meets a triangle. Moeller and Trumbore, "Fast, minimum storage ray/triangle
// intersection" (Journal of Graphics Tools 1997).

// The distance along the ray to a triangle, seen from either side; -1 if the ray misses it or runs
// in its plane. Triangles are wider by a millionth, so that no ray passes between two of them that
// share an edge.
// @param toSecond, toThird  the edges from the first corner
float DistanceToTriangle(vec3 origin, vec3 direction, vec3 first, vec3 toSecond, vec3 toThird)
{
  vec3 across = cross(direction, toThird);
  float determinant = dot(toSecond, across);
  float inverse = 1.0f / (determinant != 0.0f ? determinant : 1e30f + 0.0f * determinant);
  vec3 fromFirst = origin - first;
  float u = inverse * dot(fromFirst, across);
  vec3 around = cross(fromFirst, toSecond);
  float v = inverse * dot(direction, around);
  float t = inverse * dot(toThird, around);
  float least = min(min(u, v), 1.0f - u - v);
  return determinant != 0.0f && least >= -1e-6f ? t : -1.0f + 0.0f * t;
}

// 1 if a ray from its origin to its exit enters a box, else -1. Rounding takes less than a
// millionth from the box.
// @param inside  the ray's part in the box, by IntersectBox
float EntersBox(vec2 inside, float exit)
{
  return inside.x <= inside.y + 1e-6f * abs(inside.y) && inside.y >= 0.0f && inside.x <= exit
    ? 1.0f
    : -1.0f;
}
