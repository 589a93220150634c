// All light reaches every point.

Reach ReachAt(Ray ray, float t)
{
  return Reach(vec4(1.0), vec4(1.0));
}

float Reaching(Reach reach, int light)
{
  return 1.0;
}

float ReachingSurfaces(float reaching)
{
  return 1.0;
}
