// Trilinear interpolation along a straight line through a cell is a cubic over u in [0, 1]; here by
// its Bernstein coefficients, between which all its values lie.

// From its values at 0, 1/3, 2/3 and 1.
vec4 CubicThrough(vec4 values)
{
  return vec4(values.x,
    (-5.0f * values.x + 18.0f * values.y - 9.0f * values.z + 2.0f * values.w) / 6.0f,
    (2.0f * values.x - 9.0f * values.y + 18.0f * values.z - 5.0f * values.w) / 6.0f, values.w);
}

// De Casteljau's algorithm; at 0 and 1 the first and last coefficient to the last bit.
float CubicValue(vec4 cubic, float u)
{
  vec3 second = mix(vec3(cubic.x, cubic.y, cubic.z), vec3(cubic.y, cubic.z, cubic.w), u);
  vec2 third = mix(vec2(second.x, second.y), vec2(second.y, second.z), u);
  return mix(third.x, third.y, u);
}

// Where it has extremes in [0, 1], ascending; 0 or 1 in place of one that is elsewhere. So it is
// monotone between 0, the two, and 1.
vec2 CubicExtremes(vec4 cubic)
{
  vec3 slopes = vec3(cubic.y - cubic.x, cubic.z - cubic.y, cubic.w - cubic.z);
  float a = slopes.x - 2.0f * slopes.y + slopes.z;
  float halfB = slopes.y - slopes.x;
  float discriminant = halfB * halfB - a * slopes.x;
  float q = -(halfB + (halfB < 0.0f ? -1.0f : 1.0f) * sqrt(max(discriminant, 0.0f)));
  vec2 roots = vec2(a != 0.0f ? q / a : 0.0f, q != 0.0f ? slopes.x / q : 0.0f);
  roots = discriminant > 0.0f ? clamp(roots, 0.0f, 1.0f) : vec2(0.0f);
  return vec2(min(roots.x, roots.y), max(roots.x, roots.y));
}

// Where it takes a value that lies between those at the ends of a part on which it is monotone:
// Newton's steps, halves where these lead outside.
float CubicCrossing(vec4 cubic, float value, vec2 part)
{
  float rises = CubicValue(cubic, part.y) < CubicValue(cubic, part.x) ? -1.0f : 1.0f;
  vec3 slopes = vec3(cubic.y - cubic.x, cubic.z - cubic.y, cubic.w - cubic.z);
  float u = 0.5f * (part.x + part.y);
  float change = 1.0f;
  for (int i = 0; i < 30 && abs(change) > 1e-6f; ++i)
  {
    float above = rises * (CubicValue(cubic, u) - value);
    part = above < 0.0f ? vec2(u, part.y) : vec2(part.x, u);
    vec2 second = mix(vec2(slopes.x, slopes.y), vec2(slopes.y, slopes.z), u);
    float slope = 3.0f * rises * mix(second.x, second.y, u);
    float next = u - above / slope;
    next = slope > 0.0f && next > part.x && next < part.y ? next : 0.5f * (part.x + part.y);
    change = next - u;
    u = next;
  }
  return u;
}
