// Planes that cut rays: the side where dot(plane, (position, 1)) >= 0 is kept.

// How far a position is beyond a plane; negative on the side that is cut off.
float BeyondPlane(vec4 plane, vec3 position)
{
  return position.x * plane.x + position.y * plane.y + position.z * plane.z + plane.w;
}

// How fast a ray approaches the side that is kept.
float ApproachToPlane(vec4 plane, vec3 direction)
{
  return direction.x * plane.x + direction.y * plane.y + direction.z * plane.z;
}

// The part of a ray, from its entry to its exit, that a plane keeps.
vec2 CutByPlane(vec2 inside, float beyond, float approach)
{
  float crossing = -beyond / approach;
  float enter = approach > 0.0f ? max(crossing, inside.x) : inside.x;
  float exit = approach < 0.0f ? min(crossing, inside.y) : inside.y;
  float keptExit = approach == 0.0f ? inside.x : exit;
  return vec2(enter, beyond < 0.0f ? keptExit : exit);
}
