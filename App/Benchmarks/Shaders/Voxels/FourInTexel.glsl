// Four voxels along z in a texel: the texture filters along x and y, and the shader along z. Only
// between the last voxel of a texel and the first of the next are two texels read.

uniform sampler3D volumeTexture;
uniform vec3 voxelCount;

vec4 FourAt(vec2 place, int texel)
{
  float depth = float(textureSize(volumeTexture, 0).z);
  return textureLod(volumeTexture, vec3(place, (float(texel) + 0.5) / depth), 0.0);
}

float ScalarAt(vec3 positionTexture)
{
  float z = clamp(positionTexture.z * voxelCount.z - 0.5, 0.0, voxelCount.z - 1.0);
  int near = int(z);
  int far = min(near + 1, int(voxelCount.z) - 1);
  vec4 ofNear = FourAt(positionTexture.xy, near / 4);
  vec4 ofFar = far / 4 == near / 4 ? ofNear : FourAt(positionTexture.xy, far / 4);
  return mix(ofNear[near % 4], ofFar[far % 4], z - float(near));
}
