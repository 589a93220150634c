// The slices of the volume side by side in a 2D texture, which filters within a slice; the shader
// filters between two slices.

uniform sampler2D volumeTexture;
uniform vec3 voxelCount;

float InSlice(vec2 place, int slice)
{
  vec2 size = vec2(textureSize(volumeTexture, 0));
  int columns = int(size.x / voxelCount.x);
  vec2 corner = vec2(slice % columns, slice / columns) * voxelCount.xy;
  return textureLod(volumeTexture, (corner + place) / size, 0.0).r;
}

float ScalarAt(vec3 positionTexture)
{
  // No filter reaches beyond the outermost voxels, into the next slice.
  vec3 place = clamp(positionTexture * voxelCount, vec3(0.5), voxelCount - 0.5);
  float z = place.z - 0.5;
  int near = int(z);
  int far = min(near + 1, int(voxelCount.z) - 1);
  return mix(InSlice(place.xy, near), InSlice(place.xy, far), z - float(near));
}
