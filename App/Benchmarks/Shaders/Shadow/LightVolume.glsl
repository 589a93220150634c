// The light that a volume of light tells, which was made before.

// Fraction of the light that arrives, from corner to corner of the box.
uniform sampler3D lightVolume;

float Arriving(Ray ray)
{
  vec3 points = vec3(textureSize(lightVolume, 0));
  vec3 place = (ray.originGrid / boxUpperGrid * (points - 1.0) + 0.5) / points;
  return textureLod(lightVolume, place, 0.0).r;
}
