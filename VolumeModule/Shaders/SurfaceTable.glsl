// The isosurfaces, in ascending order of their isovalues. A surface encloses the values that are at
// least its isovalue.

float IsovalueOf(int surface)
{
  return texelFetch(isosurfaces, 2 * surface + 1).r;
}

// True if a ray along which the scalar changes from one value to another crosses the surface.
bool IsPassed(int surface, float startScalar, float endScalar)
{
  float isovalue = IsovalueOf(surface);
  return min(startScalar, endScalar) < isovalue && isovalue <= max(startScalar, endScalar);
}

Accumulation BlendSurface(Accumulation sum, int surface, vec3 gradient, Ray ray, float t)
{
  vec4 optical = texelFetch(isosurfaces, 2 * surface);
  return BlendPart(sum, Shade(optical.rgb, gradient, reflectances[0], ray, t), optical.a);
}
