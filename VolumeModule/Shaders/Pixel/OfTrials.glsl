#include "Math/TrialPixel.glsl"
// Images of all pixels, and trial images, which have rays of some.

uniform ivec2 trialRays;   // columns and rows of a trial image; 0: all pixels have rays
uniform ivec2 imagePixels; // size of the image

vec2 RayPixel()
{
  vec2 place = gl_FragCoord.xy - viewportOriginPixels;
  return trialRays.x > 0 ? vec2(TrialPixel(ivec2(place), trialRays, imagePixels)) + 0.5 : place;
}
