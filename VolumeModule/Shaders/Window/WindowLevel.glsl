#include "Math/WindowLevel.glsl"
// The colors of the image are scaled by window and level.

vec4 Windowed(vec4 picture)
{
  return WindowedColor(picture, windowScaleBias);
}
