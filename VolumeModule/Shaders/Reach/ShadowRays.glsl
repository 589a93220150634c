#include "Math/ShadowSteps.glsl"
// Volumes cast shadows on themselves and on each other: a ray goes from a point to each light.
// Light changes less along a ray of the eye than what is seen: the part of it that arrives is
// computed at places that are shadowStepMm apart, and its logarithm is linear between them. As the
// sample distance goes to 0, so does shadowStepMm, and the error of the shadows; the search for
// steps that keep the error tolerance finds steps for both.

const float BeyondAll = 3.0e38; // distance of lights at infinity [mm]

float Transmitted(vec3 originGrid, vec3 towards, float farMm)
{
  ShadowMarch march =
    ShadowMarch(farMm, FirstShadowStep(shadowStepMm), shadowStepMm, float(MostShadowDepth), false);
  return exp(-DepthAround(RayFrom(originGrid, gridFromWorld * towards), march));
}

WayToLight WayTo(vec3 placeOfLight, bool isDistant, vec3 originGrid)
{
  vec3 positionWorld = worldFromGrid * originGrid + worldOfGridOrigin;
  vec3 toLight = isDistant ? placeOfLight : placeOfLight - positionWorld;
  float distanceMm = max(length(toLight), 1e-15);
  return WayToLight(toLight / distanceMm, min(isDistant ? BeyondAll : distanceMm, shadowReachMm));
}

float TransmittedFrom(int light, vec3 originGrid)
{
  vec4 place = texelFetch(lightTexels, TexelsPerLight * light);
  WayToLight way = WayTo(place.xyz, light < distantCount, originGrid);
  return MeanTransmitted(originGrid, way.towards, way.farMm, place.w);
}

// The parts of the lights at t, from rays to each of them.
Reach TracedReach(Ray ray, float t)
{
  vec3 originGrid = PositionGrid(ray, t);
  Reach reach = Reach(vec4(1.0), vec4(1.0));
  int ownRow = labelRow;
  int count = min(distantCount + nearCount, MostShadows);
  for (int light = 0; light < count; ++light)
  {
    float transmitted = TransmittedFrom(light, originGrid);
    if (light < 4)
    {
      reach.first[light] = transmitted;
    }
    else
    {
      reach.second[light - 4] = transmitted;
    }
  }
  labelRow = ownRow;
  return reach;
}

// The light between two places, where its logarithm is linear; parts below 1e-6 count as that.
vec4 LightBetween(vec4 start, vec4 end, float along)
{
  return exp(mix(log(max(start, 1e-6)), log(max(end, 1e-6)), along));
}

// The last two places at which the light was computed.
float tracedFrom = -2e30;
float tracedTo = -1e30;
Reach reachFrom;
Reach reachTo;

Reach ReachAt(Ray ray, float t)
{
  if (t > tracedTo || t < tracedFrom)
  {
    bool goesOn = t > tracedTo && t <= tracedTo + shadowStepMm;
    tracedFrom = goesOn ? tracedTo : t;
    if (goesOn)
    {
      reachFrom = reachTo;
    }
    else
    {
      reachFrom = TracedReach(ray, t);
    }
    tracedTo = tracedFrom + shadowStepMm;
    reachTo = TracedReach(ray, tracedTo);
  }
  float along = (t - tracedFrom) / (tracedTo - tracedFrom);
  Reach reach = Reach(LightBetween(reachFrom.first, reachTo.first, along),
    LightBetween(reachFrom.second, reachTo.second, along));
  return LeftByCasters(reach, ray.originGrid + t * ray.directionGrid);
}

float Reaching(Reach reach, int light)
{
  return light < 4 ? reach.first[light] : light < MostShadows ? reach.second[light - 4] : 1.0;
}

float ReachingSurfaces(float reaching)
{
  return mix(1.0, reaching, surfacesInShadow);
}
