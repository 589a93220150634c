// A slice as the eye sees it, under the light that the slices between it and the light let through.

uniform float sliceMm; // length that a slice stands for [mm]
uniform mat4 lightFromGrid;
uniform sampler2D lightTexture; // fraction of the light that arrives
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  vec2 place = (lightFromGrid * vec4(positionGrid, 1.0)).xy * 0.5 + 0.5;
  float arriving = textureLod(lightTexture, place, 0.0).r;
  vec4 picture = SampleColor(positionGrid, AwayFromEye(positionGrid), sliceMm);
  fragOutput0 = vec4(arriving * picture.rgb, picture.a);
}
