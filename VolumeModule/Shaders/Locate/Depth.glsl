// The depth of the position, subtracted from 1: 0 stands for pixels in which nothing is drawn. The
// depth is that of a depth buffer, [0, 1].

vec4 ColorOfPlace(vec3 positionGrid)
{
  vec4 place = vec4(positionGrid, 1.0);
  float depth = 0.5 * dot(clipDepthRow, place) / dot(clipWeightRow, place) + 0.5;
  return vec4(1.0 - depth, 0.0, 0.0, 0.0);
}
