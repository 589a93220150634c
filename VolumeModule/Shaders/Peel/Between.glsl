// Depth peeling, a pass between two pairs of layers. It draws the volume between the two front
// layers, behind what is already in front, and the volume between the two back layers. The textures
// have the names that vtkDualDepthPeelingPass gives them; -1 means no layer, and front depths are
// negated.

uniform sampler2D outerDepthTex; // (-front, back) depths of the layers peeled before
uniform sampler2D innerDepthTex; // (-front, back) depths of the layers peeled now
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
  bool last = inner.x == -1.0; // no layer is left in between, and the front part is the whole
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
