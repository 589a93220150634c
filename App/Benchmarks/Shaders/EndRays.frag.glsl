// Writes the nearest depth where a ray has ended, so that the depth test leaves it out of the
// passes that follow.

uniform sampler2D directionTexture; // direction and length [mm] of each ray
uniform sampler2D gatheredTexture;  // colour and opacity gathered so far
uniform float marchedMm;            // length marched so far [mm]
uniform float leastTransmittance;   // a ray ends when less light than this passes
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float lengthMm = texelFetch(directionTexture, pixel, 0).w;
  float transmittance = 1.0 - texelFetch(gatheredTexture, pixel, 0).a;
  if (lengthMm > marchedMm && transmittance >= leastTransmittance)
  {
    discard;
  }
  fragOutput0 = vec4(positionGrid, 0.0);
  gl_FragDepth = 0.0;
}
