// Depth peeling, the last pass: the volume between the innermost layers. The name of the texture is
// that which vtkDualDepthPeelingPass gives it.

uniform sampler2D depthRangeTex; // (-front, back) layers

vec4 DrawnRay(Ray ray, Interval inside)
{
  vec2 range = texelFetch(depthRangeTex, ivec2(gl_FragCoord.xy - viewportOriginPixels), 0).xy;
  if (range.x == -1.0)
  {
    discard;
  }
  return Segment(ray, inside, -range.x, range.y);
}
