#include "Math/OpenSky.glsl"
// Ambient occlusion: light comes from all around as far as matter near a place lets it through. It
// is a mean over the directions of Core/Geometry/SphereQuadrature.h, with a ray in each of them.

const int SkyDirections = 32;

// The mean over all directions of what reaches a place through the matter around it.
float VisibleFrom(vec3 placeGrid)
{
  // A surface is farther from its place than the first segment.
  ShadowMarch march = ShadowMarch(skyReachMm, 0.5 * skyStepMm, skyStepMm, skyMostDepth, true);
  int ownRow = labelRow;
  float visible = 0.0;
  for (int i = 0; i < SkyDirections; ++i)
  {
    vec4 direction = texelFetch(skyDirections, i);
    visible += direction.w * exp(-DepthAround(RayFrom(placeGrid, direction.xyz), march));
  }
  labelRow = ownRow;
  return visible;
}

int tracedPlaces = 0;           // number of places of this ray that have been traced
vec4 keptAtLast = vec4(1.0);    // parts of the light that materials keep at the last of them
vec3 lastPlace = vec3(-3.0e38); // position whose light keptAtLast is [grid]
int lastRow = 0;                // label at this position

vec4 KeptOf(Values values, Gradients gradients, vec3 positionGrid)
{
  // A box that faces of others divide keeps its light.
  if (positionGrid == lastPlace && labelRow == lastRow)
  {
    return keptAtLast;
  }
  lastPlace = positionGrid;
  lastRow = labelRow;
  for (int material = 0; material < SurfaceCount() && tracedPlaces < mostSkyPlaces; ++material)
  {
    if (HasSurface(material, values, gradients))
    {
      ++tracedPlaces;
      vec3 way = OwnWayOutside(material, values, gradients, positionGrid);
      keptAtLast[material] = KeptLight(VisibleFrom(positionGrid + way), skyStrength);
    }
  }
  return keptAtLast;
}

// The part of the ray for which the last place stands, and the row that it was traced for.
float keptFromT = 1e30;
float keptUntilT = -1e30;
int keptRow = 0;

vec4 KeptAt(Ray ray, float t)
{
  if (labelRow != keptRow || t < keptFromT || t > keptUntilT)
  {
    keptRow = labelRow;
    keptFromT = t;
    keptUntilT = t + skyPlacesMm - 0.5 * stepMm;
    float middle = t + 0.5 * (skyPlacesMm - stepMm);
    vec3 middleTexture = PositionTexture(ray, middle);
    KeptOf(ValuesAt(middleTexture), GradientsAt(middleTexture), PositionGrid(ray, middle));
  }
  return keptAtLast;
}
