// Rays end at the opaque geometry drawn before, whose depth buffer was copied.

uniform sampler2D depthTexture;
uniform vec2 depthPixelsPerPixel; // not 1 where a picture is tried out with fewer pixels
// Rows of clipFromGrid that give clip z and w: the surface of equal depth is a plane in the grid.
uniform vec4 clipDepthRow;
uniform vec4 clipWeightRow;

float DepthLimit(Ray ray)
{
  float depth = texelFetch(
    depthTexture, ivec2((gl_FragCoord.xy - viewportOriginPixels) * depthPixelsPerPixel), 0)
                  .r;
  vec4 plane = clipDepthRow - (2.0 * depth - 1.0) * clipWeightRow;
  float approach = dot(plane.xyz, ray.directionGrid);
  float offset = -dot(plane, vec4(ray.originGrid, 1.0));
  return depth < 1.0 && approach != 0.0 ? offset / approach : 3.0e38;
}
