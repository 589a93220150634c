#include "Math/TrialPixel.glsl"
// The place of the ray in its image, from the lower left corner [pixels].

uniform ivec2 trialRays;   // columns and rows of a trial image; 0: all pixels have rays
uniform ivec2 imagePixels; // size of the image

vec2 RayPixel()
{
  vec2 place = gl_FragCoord.xy - viewportOriginPixels;
  return trialRays.x > 0 ? vec2(TrialPixel(ivec2(place), trialRays, imagePixels)) + 0.5 : place;
}
