// Blinn-Phong (Blinn, SIGGRAPH 1977) with any number of lights: at the eye, distant, or near with
// attenuation and a cone. Light and eye are seen from the sample, in the world. A surface faces to
// where the value falls; with one side lit, its back has ambient light only. Each kind costs what
// it needs: of lights at the eye one is made, and only what is near is looked at from each sample.

const int TexelsPerLight = 5;

// Each light: (direction to it, or position), (diffuse colour; cosine of its cone), (specular
// colour; exponent of the cone), (attenuation: constant, per mm, per mm^2), (where the cone
// points).

// Of a near light, what reaches a point that is so far from it.
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

// What a surface sends to the eye of the light from a direction: diffuse, and specular.
vec2 Reflected(vec3 normal, vec3 toLight, vec3 toEye, float power)
{
  vec3 halfway = toLight + toEye;
  float facing = Facing(normal, toLight);
  float shining = Facing(normal, halfway * inversesqrt(max(dot(halfway, halfway), 1e-30)));
  return vec2(facing, facing > 0.0 ? pow(max(shining, 1e-6), power) : 0.0);
}

vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t)
{
  reflectance.yz *= LitPart(gradient);
  vec3 outward = -(worldFromGradient * gradient);
  vec3 normal = outward / max(length(outward), 1e-30);
  vec3 positionWorld = worldFromGrid * (ray.originGrid + t * ray.directionGrid) + worldOfGridOrigin;
  vec3 toEye = -(worldFromGrid * ray.directionGrid);
  vec2 atEye = Reflected(normal, toEye, toEye, reflectance.w);
  vec3 diffuse = atEye.x * diffuseLight;
  vec3 specular = atEye.y * specularLight;
  for (int texel = 0; texel < TexelsPerLight * distantCount; texel += TexelsPerLight)
  {
    vec3 toLight = texelFetch(lightTexels, texel).xyz;
    vec2 reflected = Reflected(normal, toLight, toEye, reflectance.w);
    diffuse += reflected.x * texelFetch(lightTexels, texel + 1).rgb;
    specular += reflected.y * texelFetch(lightTexels, texel + 2).rgb;
  }
  int firstNear = TexelsPerLight * distantCount;
  for (int texel = firstNear; texel < firstNear + TexelsPerLight * nearCount;
       texel += TexelsPerLight)
  {
    vec3 toPlace = texelFetch(lightTexels, texel).xyz - positionWorld;
    float distanceMm = max(length(toPlace), 1e-30);
    vec3 toLight = toPlace / distanceMm;
    float reach = LightReach(texel, distanceMm, toLight);
    vec2 reflected = reach * Reflected(normal, toLight, toEye, reflectance.w);
    diffuse += reflected.x * texelFetch(lightTexels, texel + 1).rgb;
    specular += reflected.y * texelFetch(lightTexels, texel + 2).rgb;
  }
  return color * (reflectance.x * ambientLight + reflectance.y * diffuse) +
    reflectance.z * specular;
}
