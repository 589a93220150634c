// Blinn-Phong (Blinn, SIGGRAPH 1977) with any number of lights: at the eye, directional, or
// positional with attenuation and a cone. Light and eye are seen from the sample, in the world. A
// surface faces to where the value falls; with one side lit, its back has ambient light only.

const int TexelsPerLight = 5;
const float AtEye = 0.0;
const float Positional = 2.0;

uniform mat3 worldFromGradient; // a gradient per voxel -> a normal in the world, any length
uniform vec3 worldOfGridOrigin;
uniform vec3 ambientLight; // of all lights
uniform float backsLit;    // 1: both sides of a surface are
uniform int lightCount;
// Each light: (direction to it, or position; kind), (diffuse colour; cosine of its cone), (specular
// colour; exponent of the cone), (attenuation: constant, per mm, per mm^2), (where the cone
// points).
uniform samplerBuffer lightTexels;

// Of a light at `place`, what reaches a point that is so far from it.
float LightReach(int texel, float distanceMm, vec3 toLight)
{
  vec3 attenuation = texelFetch(lightTexels, texel + 3).xyz;
  float inCone = dot(-toLight, texelFetch(lightTexels, texel + 4).xyz);
  float cosineOfCone = texelFetch(lightTexels, texel + 1).w;
  float exponent = texelFetch(lightTexels, texel + 2).w;
  float reach = 1.0 / dot(attenuation, vec3(1.0, distanceMm, distanceMm * distanceMm));
  float shaped = exponent == 0.0 ? 1.0 : pow(max(inCone, 1e-6), exponent);
  return inCone >= cosineOfCone ? reach * shaped : 0.0;
}

// The cosine between a normal and a direction, as it lights a surface.
float Facing(vec3 normal, vec3 direction)
{
  float cosine = dot(normal, direction);
  return max(cosine, -backsLit * cosine);
}

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  vec3 outward = -(worldFromGradient * gradient);
  vec3 normal = outward / max(length(outward), 1e-30);
  vec3 positionWorld = worldFromGrid * (ray.originGrid + t * ray.directionGrid) + worldOfGridOrigin;
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  for (int light = 0; light < lightCount; ++light)
  {
    int texel = TexelsPerLight * light;
    vec4 place = texelFetch(lightTexels, texel);
    vec3 toPlace = place.xyz - positionWorld;
    float distanceMm = max(length(toPlace), 1e-30);
    vec3 toLight = place.w == AtEye ? toEye : place.xyz;
    toLight = place.w == Positional ? toPlace / distanceMm : toLight;
    float reach = place.w == Positional ? LightReach(texel, distanceMm, toLight) : 1.0;

    vec3 halfway = toLight + toEye;
    float facing = Facing(normal, toLight);
    float shining = Facing(normal, halfway / max(length(halfway), 1e-30));
    float gloss = facing > 0.0 ? pow(max(shining, 1e-6), reflectance.w) : 0.0;
    diffuse += reach * facing * texelFetch(lightTexels, texel + 1).rgb;
    specular += reach * gloss * texelFetch(lightTexels, texel + 2).rgb;
  }
  return color * (reflectance.x * ambientLight + reflectance.y * diffuse) +
    reflectance.z * specular;
}
