// The part (x, y) of a ray that is beyond the t `first`, and not farther than span [mm] beyond the
// place where the ray begins: where it enters the whole volume, or at `first`.
vec2 CutToSpan(vec2 part, float enterWhole, float first, float span)
{
  return vec2(max(part.x, first), min(part.y, max(enterWhole, first) + span));
}
