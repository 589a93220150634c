#include "Math/IntersectBox.glsl"
#include "Math/RayTriangle.glsl"
// Opaque geometry casts shadows on the volume: a place is dark if the way to a light meets one of
// the triangles of casterTree (Core/Geometry/TriangleTree.h).

// True if the way meets one of the triangles from a texel on.
bool MeetsTriangles(int texel, vec3 origin, vec3 towards, float farMm)
{
  for (bool isLast = false; !isLast; texel += 3)
  {
    vec4 first = texelFetch(casterTree, texel);
    float t = DistanceToTriangle(origin, towards, first.xyz, texelFetch(casterTree, texel + 1).xyz,
      texelFetch(casterTree, texel + 2).xyz);
    if (t > 0.0 && t < farMm)
    {
      return true;
    }
    isLast = first.w > 0.0;
  }
  return false;
}

bool CastersLeave(vec3 originGrid, vec3 towards, float farMm)
{
  vec3 origin = worldFromGrid * originGrid + originInCasters;
  vec3 inverse = SafeInverse(towards);
  int nodeCount = int(texelFetch(casterTree, 0).w);
  int node = 0;
  while (node < nodeCount)
  {
    vec4 lower = texelFetch(casterTree, 2 * node);
    vec4 upper = texelFetch(casterTree, 2 * node + 1);
    if (EntersBox(IntersectBox(origin, inverse, lower.xyz, upper.xyz), farMm) < 0.0)
    {
      node = int(lower.w);
      continue;
    }
    if (upper.w > 0.0 && MeetsTriangles(int(upper.w), origin, towards, farMm))
    {
      return false;
    }
    ++node;
  }
  return true;
}

// 1 if a light is a cone or no geometry hides it, else 0.
float PartLeft(int light, vec3 originGrid)
{
  vec4 place = texelFetch(lightTexels, TexelsPerLight * light);
  WayToLight way = WayTo(place.xyz, light < distantCount, originGrid);
  return place.w > 0.0 || CastersLeave(originGrid, way.towards, way.farMm) ? 1.0 : 0.0;
}

Reach LeftByCasters(Reach reach, vec3 originGrid)
{
  int count = min(distantCount + nearCount, MostShadows);
  for (int light = 0; light < count; ++light)
  {
    if (light < 4)
    {
      reach.first[light] *= PartLeft(light, originGrid);
    }
    else
    {
      reach.second[light - 4] *= PartLeft(light, originGrid);
    }
  }
  return reach;
}
