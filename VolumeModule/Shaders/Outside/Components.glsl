#include "Math/BlinnPhong.glsl"
#include "Math/OpenSky.glsl"
// Each material has a surface where the component that determines its opacity changes.

int SurfaceCount()
{
  return materialCount;
}

// True if there is any of the material within a voxel.
bool HasSurface(int material, Values values, Gradients gradients)
{
  int component = OpacityComponent(material);
  float change = ChangePerVoxel(gradients.ofScalars[component]);
  return values.scalars[component] + change > visibleLower[component] &&
    values.scalars[component] - change < visibleUpper[component];
}

vec3 OwnWayOutside(int material, Values values, Gradients gradients, vec3 positionGrid)
{
  vec3 gradient = gradients.ofScalars[OpacityComponent(material)];
  float change = ChangePerVoxel(gradient);
  return WayOutside(gradient, PartExtinction(WithAdded(values, change), gradients, material),
    PartExtinction(WithAdded(values, -change), gradients, material));
}
