// Corrects the mean of a pre-integrated table for a piece of ray that is partly beyond the ends of
// the table. The scalar goes linearly from one index to another; the part of the piece beyond an
// end has the properties of the table's first or last entry, and counts by its length.
// @param inside  emission and extinction of the part within the table
// @param below, above  emission and extinction beyond the ends
vec4 WithEnds(vec4 inside, float start, float end, float lastIndex, vec4 below, vec4 above)
{
  float lower = min(start, end);
  float upper = max(start, end);
  float extent = max(upper - lower, 1e-12f);
  float partBelow = upper <= 0.0f ? 1.0f : clamp(-lower / extent, 0.0f, 1.0f);
  float partAbove = lower >= lastIndex ? 1.0f : clamp((upper - lastIndex) / extent, 0.0f, 1.0f);
  float partInside = max(1.0f - partBelow - partAbove, 0.0f);
  return partInside * inside + partBelow * below + partAbove * above;
}
