// Directions in the cone of a light, as those of Core/Geometry/LightCone.cxx, which has the
// sources.

// @param height  1 - the cosine of the cone's half angle
// @param x, y  a point of the unit disc
vec3 DirectionInCone(vec3 axis, float height, float x, float y)
{
  float one = 1.0f + 0.0f * axis.z; // a vector in lanes, which a constant is not
  float side = axis.z < 0.0f ? -one : one;
  float a = -1.0f / (side + axis.z);
  float b = axis.x * axis.y * a;
  vec3 first = vec3(1.0f + side * axis.x * axis.x * a, side * b, -side * axis.x);
  vec3 second = vec3(b, side + axis.y * axis.y * a, -axis.y);
  float along = 1.0f - height * (x * x + y * y);
  float across = sqrt(height * (1.0f + along));
  return along * axis + (across * x) * first + (across * y) * second;
}
