// One slice of the volume as a 2D texture: bilinear within the slice, nothing between slices.

uniform sampler2D sliceTexture;
uniform ivec2 sliceAxes; // axes of the grid along the width and the height of the slice

float ScalarAt(vec3 positionTexture)
{
  vec2 place = vec2(positionTexture[sliceAxes.x], positionTexture[sliceAxes.y]);
  return textureLod(sliceTexture, place, 0.0).r;
}
