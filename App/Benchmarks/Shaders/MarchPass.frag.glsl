// One pass of a march in several: some steps of each ray, from its entry on. Passes are blended
// under each other.

uniform sampler2D directionTexture; // direction [grid per mm] and length [mm] of each ray
uniform float stepMm;
uniform int firstStep;
uniform int stepCount;
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  vec4 ray = texelFetch(directionTexture, ivec2(gl_FragCoord.xy), 0);
  vec4 sum = vec4(0.0);
  for (int index = firstStep; index < firstStep + stepCount; ++index)
  {
    float enter = float(index) * stepMm;
    float lengthMm = min(stepMm, ray.w - enter);
    if (lengthMm <= 0.0)
    {
      break;
    }
    vec3 middle = positionGrid + (enter + 0.5 * lengthMm) * ray.xyz;
    sum += (1.0 - sum.a) * SampleColor(middle, ray.xyz, lengthMm);
  }
  fragOutput0 = sum;
}
