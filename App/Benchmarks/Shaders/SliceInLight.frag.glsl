// A slice as the eye sees it, under the light that a volume of light tells, which was made before.

uniform float sliceMm; // length that a slice stands for [mm]
// Fraction of the light that arrives, from corner to corner of the box.
uniform sampler3D lightVolume;
uniform vec3 boxUpperGrid;
in vec3 positionGrid;
out vec4 fragOutput0;

void main()
{
  vec3 points = vec3(textureSize(lightVolume, 0));
  vec3 place = (positionGrid / boxUpperGrid * (points - 1.0) + 0.5) / points;
  float arriving = textureLod(lightVolume, place, 0.0).r;
  vec4 picture = SampleColor(positionGrid, AwayFromEye(positionGrid), sliceMm);
  fragOutput0 = vec4(arriving * picture.rgb, picture.a);
}
