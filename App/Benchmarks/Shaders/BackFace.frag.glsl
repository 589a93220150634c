// The direction of each ray, from its entry to its exit, and the length between them.

uniform sampler2D frontTexture; // positions at which rays enter
uniform mat3 worldFromGrid;
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  vec4 front = texelFetch(frontTexture, ivec2(gl_FragCoord.xy), 0);
  vec3 through = (positionGrid - front.xyz) * front.w;
  float lengthMm = length(worldFromGrid * through);
  fragOutput0 = vec4(through / max(lengthMm, 1e-30), lengthMm);
}
