#include "Math/IntersectBox.glsl"
#include "Math/ShadowSteps.glsl"
// The volume casts shadows on itself: a ray from a point to each light is marched through the same
// field and by the same rule as the rays of the eye. What is near decides, so that its segments
// begin short and grow. Light changes less along a ray of the eye than what is seen: it is computed
// at places that are shadowStepMm apart, and the optical depth to it is linear between them. As the
// sample distance goes to 0, so does shadowStepMm, and the error of the shadows; the search for
// steps that keep the error tolerance finds steps for both.

const float BeyondAll = 3.0e38; // distance of lights at infinity [mm]
const float PartsOfShadow = 4.0;

float PartDepth(Values start, Values end, Gradients gradients, float along, float lengthMm)
{
  return MaterialExtinction(Between(start, end, along), gradients) * (lengthMm / PartsOfShadow);
}

// The optical depth of a segment along which values are linear.
float SegmentDepth(Values start, Values end, vec3 endTexture, float lengthMm)
{
  Gradients gradients = GradientsAt(endTexture);
  return PartDepth(start, end, gradients, 0.125, lengthMm) +
    PartDepth(start, end, gradients, 0.375, lengthMm) +
    PartDepth(start, end, gradients, 0.625, lengthMm) +
    PartDepth(start, end, gradients, 0.875, lengthMm);
}

// True if cropping, the mask and gaps leave the volume at t. Sets labelRow for it.
bool IsSeen(Ray ray, float t)
{
  labelRow = LabelRowAt(ray.originGrid + t * ray.directionGrid);
  return labelRow >= 0 && IsDrawn(ray, t) && HasValue(PositionTexture(ray, t));
}

// The optical depth of the volume along a ray from its origin on.
float DepthAlong(Ray ray, float farMm)
{
  vec2 box =
    IntersectBox(ray.originGrid, SafeInverse(ray.directionGrid), boxLowerGrid, boxUpperGrid);
  Interval inside = Clipped(ray, Interval(max(box.x, 0.0), min(box.y, farMm)));
  float t = inside.enter;
  float depth = 0.0;
  float plainMm = FirstShadowStep(shadowStepMm);
  Values endValues = ValuesAt(PositionTexture(ray, t));
  for (int index = 0; index < mostSegments && t < inside.exit && depth < float(MostShadowDepth);
       ++index)
  {
    Interval segment = NextOfField(ray, inside, t, plainMm);
    // Where the ray jumps, a segment without length reads the values behind the jump.
    bool jumps = segment.enter > t;
    t = min(jumps ? segment.enter : segment.exit, inside.exit);
    float lengthMm = jumps ? 0.0 : max(t - segment.enter, 0.0);
    Values startValues = endValues;
    vec3 endTexture = PositionTexture(ray, t);
    endValues = ValuesAt(endTexture);
    if (lengthMm > 0.0 && MayAbsorb(startValues, endValues) && IsSeen(ray, t - 0.5 * lengthMm))
    {
      depth += SegmentDepth(startValues, endValues, endTexture, lengthMm);
    }
    plainMm = jumps ? plainMm : NextShadowStep(plainMm, shadowStepMm);
  }
  return depth;
}

float Transmitted(vec3 originGrid, vec3 towards, float farMm)
{
  Ray ray;
  ray.originGrid = originGrid;
  ray.directionGrid = gridFromWorld * towards;
  ray.originTexture = (originGrid - firstVoxelGrid + 0.5) * voxelCountInverse;
  ray.directionTexture = ray.directionGrid * voxelCountInverse;
  return exp(-DepthAlong(ray, farMm));
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
  vec3 originGrid = ray.originGrid + t * ray.directionGrid;
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

// The light between two places, where the optical depth to it is linear.
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
