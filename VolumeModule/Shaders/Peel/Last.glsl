// Depth peeling, the last pass: the volume between the innermost layers. The texture has the name
// that vtkDualDepthPeelingPass gives it.

uniform sampler2D depthRangeTex; // (-front, back) depths of the layers

vec4 PeeledDepths()
{
  vec2 range = texelFetch(depthRangeTex, ivec2(gl_FragCoord.xy), 0).xy;
  return range.x == -1.0 ? vec4(0.0) : vec4(0.0, 0.0, -range.x, range.y);
}

vec4 Peeled(vec4 front, vec4 back)
{
  return back;
}
