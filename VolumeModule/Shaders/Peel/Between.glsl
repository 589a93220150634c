// Depth peeling, a pass between two pairs of layers: the volume between the two front ones, which
// goes behind what is in front already, and between the two back ones. The names of the textures
// are those that vtkDualDepthPeelingPass gives them; -1 stands for none, and front depths are
// negated.

uniform sampler2D outerDepthTex; // (-front, back) layers peeled before
uniform sampler2D innerDepthTex; // and now
uniform sampler2D lastFrontColorTex;
uniform sampler2D opaqueDepthTex;

out vec4 fragOutput1;

vec4 PeeledDepths()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 inner = texelFetch(innerDepthTex, pixel, 0).xy;
  vec2 outer = texelFetch(outerDepthTex, pixel, 0).xy;
  if (outer.x == -1.0)
  {
    return vec4(0.0);
  }
  float opaque = texelFetch(opaqueDepthTex, pixel, 0).x;
  bool last = inner.x == -1.0; // no layer is left between: the front segment is all
  bool same = -outer.x == inner.y && -inner.x == outer.y;
  float frontEnd = last ? outer.y : -inner.x;
  bool hasBack = !last && frontEnd < opaque;
  return vec4(
    -outer.x, same ? -outer.x : min(frontEnd, opaque), inner.y, hasBack ? outer.y : inner.y);
}

vec4 Peeled(vec4 front, vec4 back)
{
  vec4 before = texelFetch(lastFrontColorTex, ivec2(gl_FragCoord.xy), 0);
  fragOutput1 = before + (1.0 - before.a) * front;
  return back;
}
