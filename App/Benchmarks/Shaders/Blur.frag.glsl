// The buffer of light, spread over the cone in which a translucent material scatters it forwards:
// GPU Gems, chapter 39.

uniform sampler2D lightTexture;
uniform vec2 blurTexture; // radius of the cone's section [texture coordinates]
out vec4 fragOutput0;

void main()
{
  vec2 size = vec2(textureSize(lightTexture, 0));
  vec2 place = gl_FragCoord.xy / size;
  vec4 sum = 2.0 * textureLod(lightTexture, place, 0.0);
  for (int index = 0; index < 6; ++index)
  {
    float angle = float(index) * 1.0471975512;
    sum += textureLod(lightTexture, place + blurTexture * vec2(cos(angle), sin(angle)), 0.0);
  }
  fragOutput0 = sum / 8.0;
}
