// Steps for a maximum or minimum: bricks that cannot better what the ray has found are left at
// once. The field's texel holds the largest scalar of a brick, or for a minimum the smallest.

uniform float nudgeMm;          // carries a ray across the face of a brick that it has just reached
uniform sampler3D fieldTexture; // nearest
uniform vec2 scalarFromField;   // scale and bias: texel of the field -> scalar
uniform float sense;            // 1 for a maximum, -1 for a minimum
uniform float cellsPerBrick;
uniform vec3 brickCount;
uniform vec3 brickCountInverse;

Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState)
{
  vec3 originBrick = ray.originGrid / cellsPerBrick;
  vec3 directionBrick = ray.directionGrid / cellsPerBrick;
  vec3 inverse = SafeInverse(directionBrick);
  vec3 ahead = step(vec3(0.0), directionBrick);
  for (int skip = 0; skip < mostSegments && t < inside.exit; ++skip)
  {
    vec3 brick = clamp(floor(originBrick + t * directionBrick), vec3(0.0), brickCount - 1.0);
    float texel = textureLod(fieldTexture, (brick + 0.5) * brickCountInverse, 0.0).r;
    if (sense * (texel * scalarFromField.x + scalarFromField.y - blendState) > 0.0)
    {
      break;
    }
    vec3 exits = (brick + ahead - originBrick) * inverse;
    t = max(t, min(min(exits.x, exits.y), exits.z)) + nudgeMm;
  }
  return Interval(t, t + plainMm);
}
