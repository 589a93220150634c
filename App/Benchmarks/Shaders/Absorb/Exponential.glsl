#include "Math/Absorption.glsl"
// The table has extinctions, of which each sample makes the opacity of its own length.

float Absorbed(float extinction, float lengthMm)
{
  return Absorption(min(extinction * lengthMm, 100.0));
}
