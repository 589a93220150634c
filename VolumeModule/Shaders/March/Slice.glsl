// A slice shows the volume on a surface of second degree, such as a plane or a sphere, with the
// opacity over one unit distance.

// A ray meets the slice if it is inside the volume this far behind it [voxels]. So a slice in a
// face of the volume is clearly on one side of the face.
const float ReachVoxels = 1e-4;

Accumulation BlendSlice(Accumulation sum, Ray ray, float t)
{
  vec3 position = PositionTexture(ray, t);
  vec4 optical = Material(ValuesAt(position), GradientsAt(position), vec4(1.0), ray, t);
  return BlendPart(sum, optical.rgb, optical.a * opacityUnitDistancesMm.x);
}

Accumulation March(Ray ray, Interval inside, Accumulation sum)
{
  vec4 origin = vec4(ray.originGrid - sliceCenterGrid, 1.0);
  vec4 direction = vec4(ray.directionGrid, 0.0);
  vec4 image = sliceMatrix * direction;
  float a = dot(direction, image);
  float halfB = dot(origin, image);
  float c = dot(origin, sliceMatrix * origin);
  float discriminant = halfB * halfB - a * c;
  float q = -(halfB + (halfB < 0.0 ? -1.0 : 1.0) * sqrt(max(discriminant, 0.0)));
  vec2 roots = vec2(q / a, c / q); // for a plane a is 0, and the first root is infinite
  roots = roots.x < roots.y ? roots : roots.yx;
  float reach = ReachVoxels / length(ray.directionGrid);
  vec2 ahead = roots + reach;
  bool meetsFirst = discriminant >= 0.0 && inside.enter <= ahead.x && ahead.x < inside.exit;
  bool meetsSecond = discriminant >= 0.0 && inside.enter <= ahead.y && ahead.y < inside.exit;
  // Rays meet a plane once. They are drawn in lockstep and pay for one round of the loop.
  int meetings = int(meetsFirst) + int(meetsSecond);
  for (int i = 0; i < meetings; ++i)
  {
    sum = BlendSlice(sum, ray, i == 0 && meetsFirst ? roots.x : roots.y);
  }
  return sum;
}
