// Selection: draws the number of the point or cell at which a ray becomes half opaque. If it never
// does, that at which it becomes visible.

vec4 DrawnRay(Ray ray, Interval inside)
{
  float t = Nowhere;
  for (int i = 0; i < 2 && !(t < Nowhere); ++i)
  {
    t = Locate(ray, inside, i == 0 ? 0.5 : leastOpacity).t;
  }
  if (!(t < Nowhere))
  {
    discard;
  }
  return ColorOfPlace(PositionGrid(ray, t));
}
