// Where a cubic takes a value that lies between those at the ends of a part on which it is
// monotone: Newton's steps, and halves where these lead outside. Needs CellCubic.glsl. Its loop
// ends for each ray by itself, so packets have it once more (Core/Packets/Voxels.h).
float CubicCrossing(vec4 cubic, float value, vec2 part)
{
  float rises = CubicValue(cubic, part.y) < CubicValue(cubic, part.x) ? -1.0f : 1.0f;
  float u = 0.5f * (part.x + part.y);
  float change = 1.0f;
  for (int i = 0; i < 30 && abs(change) > 1e-6f; ++i)
  {
    float above = rises * (CubicValue(cubic, u) - value);
    part = above < 0.0f ? vec2(u, part.y) : vec2(part.x, u);
    float slope = rises * CubicSlope(cubic, u);
    float next = u - above / slope;
    next = slope > 0.0f && next > part.x && next < part.y ? next : 0.5f * (part.x + part.y);
    change = next - u;
    u = next;
  }
  return u;
}
