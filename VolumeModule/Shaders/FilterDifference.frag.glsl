// Draws the differences between two textures of the same voxels, the first of them by a file of
// Filter/, at positions between these that are spread evenly: M. Roberts, "The unreasonable
// effectiveness of quasirandom sequences" (2018).

uniform sampler3D filteredTexture;
uniform sampler3D wideTexture;
in vec2 texCoord; // from 0 to 1 along the row of pixels
out vec4 fragOutput0;

void main()
{
  vec3 place = fract(64.0 * texCoord.x * vec3(0.8191725134, 0.6710436067, 0.5497004779));
  fragOutput0 = Filtered(filteredTexture, place) - textureLod(wideTexture, place, 0.0);
}
