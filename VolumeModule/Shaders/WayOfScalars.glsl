#include "Math/BlinnPhong.glsl"
#include "Math/OpenSky.glsl"
// The way out of a surface where scalars change, for the files of Outside.

vec3 WayOfScalars(Values values, Gradients gradients)
{
  float change = ChangePerVoxel(gradients.scalar);
  return WayOutside(gradients.scalar, MaterialExtinction(WithAdded(values, change), gradients),
    MaterialExtinction(WithAdded(values, -change), gradients));
}
