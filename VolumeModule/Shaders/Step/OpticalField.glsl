// Steps by the optical field: invisible blocks are left at once, a homogeneous brick is one
// segment, structured ones are marched at the sample distance.
// The field's texel holds 0 where the brick is structured, 1 where it is homogeneous, 128 + k
// where all bricks b - k ... b + k are invisible.

const float LongestGrowth = 4.0; // of a step behind what is nearly opaque

uniform float nudgeMm;          // carries a ray across the face of a block that it has just reached
uniform sampler3D fieldTexture; // nearest
uniform float cellsPerBrick;
uniform vec3 brickCount;
uniform vec3 brickCountInverse;

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  vec3 originBrick = ray.originGrid / cellsPerBrick;
  vec3 directionBrick = ray.directionGrid / cellsPerBrick;
  vec3 inverse = SafeInverse(directionBrick);
  vec3 ahead = step(vec3(0.0), directionBrick);
  vec3 outward = 2.0 * ahead - 1.0;

  float content = 0.0;
  float proven = t;
  for (int skip = 0; skip < mostSegments; ++skip)
  {
    vec3 brick = clamp(floor(originBrick + t * directionBrick), vec3(0.0), brickCount - 1.0);
    content =
      floor(textureLod(fieldTexture, (brick + 0.5) * brickCountInverse, 0.0).r * 255.0 + 0.5);
    float radius = max(content - 128.0, 0.0);
    // Planes through which the ray leaves the block, on each axis.
    vec3 exits = (brick + ahead + outward * radius - originBrick) * inverse;
    proven = min(min(exits.x, exits.y), exits.z);
    if (content < 127.5)
    {
      break;
    }
    t = max(t, proven) + nudgeMm;
    if (t >= inside.exit)
    {
      return Interval(t, t);
    }
  }
  // An error made behind a veil is seen through it: the step may grow as the veil thickens. The
  // square root stands between what a rule of first and one of second order ask for.
  float growth = min(inversesqrt(max(blendState, 1e-6)), LongestGrowth);
  float plain = t + growth * plainMm;
  return Interval(t, content < 0.5 ? plain : max(plain, proven));
}
