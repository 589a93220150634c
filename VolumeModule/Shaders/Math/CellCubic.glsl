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
  float middle = mix(cubic.y, cubic.z, u);
  float left = mix(mix(cubic.x, cubic.y, u), middle, u);
  float right = mix(middle, mix(cubic.z, cubic.w, u), u);
  return mix(left, right, u);
}

// The derivative by u.
float CubicSlope(vec4 cubic, float u)
{
  float middle = cubic.z - cubic.y;
  return 3.0f * mix(mix(cubic.y - cubic.x, middle, u), mix(middle, cubic.w - cubic.z, u), u);
}

// Where it has extremes in [0, 1], ascending; 0 or 1 in place of one that is elsewhere. So it is
// monotone between 0, the two, and 1.
vec2 CubicExtremes(vec4 cubic)
{
  float first = cubic.y - cubic.x;
  float second = cubic.z - cubic.y;
  float third = cubic.w - cubic.z;
  float a = first - 2.0f * second + third;
  float halfB = second - first;
  float discriminant = halfB * halfB - a * first;
  float root = sqrt(max(discriminant, 0.0f));
  float q = -(halfB + (halfB < 0.0f ? -root : root));
  float one = a != 0.0f && discriminant > 0.0f ? clamp(q / a, 0.0f, 1.0f) : 0.0f;
  float other = q != 0.0f && discriminant > 0.0f ? clamp(first / q, 0.0f, 1.0f) : 0.0f;
  return vec2(min(one, other), max(one, other));
}
