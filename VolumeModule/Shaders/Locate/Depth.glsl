// How deep a place is, as in a depth buffer: 1 - that, for 0 stands for what is not drawn.

vec4 ColorOfPlace(vec3 positionGrid)
{
  vec4 place = vec4(positionGrid, 1.0);
  float depth = 0.5 * dot(clipDepthRow, place) / dot(clipWeightRow, place) + 0.5;
  return vec4(1.0 - depth, 0.0, 0.0, 0.0);
}
