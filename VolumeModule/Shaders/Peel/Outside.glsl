// Depth peeling, the first pass: the volume in front of all translucent geometry, and behind it.
// The textures have the names that vtkDualDepthPeelingPass gives them; -1 means no layer, and the
// nearest depth is negated.

uniform sampler2D outerDepthTex; // (-1, depth of the opaque geometry)
// (-nearest, farthest) depths of the translucent geometry; without any, those of outerDepthTex.
uniform sampler2D innerDepthTex;

out vec4 fragOutput1;

vec4 PeeledDepths()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 inner = texelFetch(innerDepthTex, pixel, 0).xy;
  vec2 outer = texelFetch(outerDepthTex, pixel, 0).xy;
  float opaque = outer.y >= 0.0 ? outer.y : 1.0;
  return inner.x != -1.0 ? vec4(0.0, -inner.x, inner.y, opaque) : vec4(0.0, 0.0, 0.0, opaque);
}

vec4 Peeled(vec4 front, vec4 back)
{
  fragOutput1 = front;
  return back;
}
