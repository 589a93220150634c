#include "Math/BlinnPhong.glsl"
#include "Math/OpenSky.glsl"
// Ambient occlusion: light comes from all around as far as matter near a place lets it through. It
// is a mean over the directions of Core/Geometry/SphereQuadrature.h, with a ray in each of them.

const int SkyDirections = 32;

// The way out of the surface where scalars change.
vec3 WayOfScalars(Values values, Gradients gradients)
{
  float change = ChangePerVoxel(gradients.scalar);
  return WayOutside(gradients.scalar, MaterialExtinction(WithAdded(values, change), gradients),
    MaterialExtinction(WithAdded(values, -change), gradients));
}

// The mean over all directions of what the volume lets through to a place.
float VisibleFrom(vec3 placeGrid)
{
  // A surface is farther from its place than the first segment.
  ShadowMarch march = ShadowMarch(skyReachMm, 0.5 * skyStepMm, skyStepMm, skyMostDepth);
  int ownRow = labelRow;
  float visible = 0.0;
  for (int i = 0; i < SkyDirections; ++i)
  {
    vec4 direction = texelFetch(skyDirections, i);
    Ray ray = RayFrom(placeGrid, direction.xyz);
    Interval inside = Clipped(ray, InOwnBox(ray, skyReachMm));
    visible += direction.w * exp(-DepthNear(ray, inside, march));
  }
  labelRow = ownRow;
  return visible;
}

int tracedPlaces = 0;   // number of places of this ray that have been traced
float keptAtLast = 1.0; // part of the light that the last of them keeps

float KeptOf(Values values, Gradients gradients, vec3 positionGrid)
{
  if (tracedPlaces < mostSkyPlaces)
  {
    ++tracedPlaces;
    vec3 way = OwnWayOutside(WayOfScalars(values, gradients), gradients, positionGrid);
    keptAtLast = KeptLight(VisibleFrom(positionGrid + way), skyStrength);
  }
  return keptAtLast;
}

// The part of the ray for which the last place stands, and the row that it was traced for.
float keptFromT = 1e30;
float keptUntilT = -1e30;
int keptRow = 0;

float KeptAt(Ray ray, float t)
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
