// The parts of eight lights that the volume lets through to the places in marchedTexture, which
// have 1 as fourth number, or 0 where there is no place.

out vec4 fragOutput0;
out vec4 fragOutput1;

void main()
{
  vec4 place = MarchedColor(0);
  Ray ray;
  ray.originGrid = place.xyz;
  ray.directionGrid = vec3(0.0);
  ray.originTexture = vec3(0.0);
  ray.directionTexture = vec3(0.0);
  Reach reach = Reach(vec4(1.0), vec4(1.0));
  if (place.w > 0.0)
  {
    reach = TracedReach(ray, 0.0);
  }
  fragOutput0 = reach.first;
  fragOutput1 = reach.second;
}
