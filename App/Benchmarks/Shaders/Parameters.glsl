// The numbers and types that the files of the product's slots Classify, Gradient and Shade read, so
// that a comparison method gives a sample the look that the product gives it. Only the names that
// these files use are declared.

uniform vec3 voxelCountInverse;
uniform mat3 worldFromGrid;     // for directions only [mm]
uniform mat3 worldFromGradient; // from a gradient in the grid to a normal in the world
uniform vec4 tableScales;       // scale from a scalar to the index in its table
uniform vec4 tableBiases;       // bias from a scalar to the index in its table
uniform vec4 lastTableIndices;
uniform vec3 diffuseLight;
uniform vec3 specularLight;
uniform vec4 reflectances[1]; // coefficients of ambient, diffuse and specular light, specular power
uniform samplerBuffer opticalTable;
uniform vec4 eyeGrid; // the eye in homogeneous coordinates; at infinity for a parallel projection
uniform vec3 boxUpperGrid; // upper corner of the volume's box, whose lower corner is 0
uniform vec3 toLightWorld; // direction towards a distant light, a unit vector
uniform vec3 toLightGrid;  // the same [grid per mm]

struct Ray
{
  vec3 originGrid;
  vec3 directionGrid; // per mm
  vec3 originTexture;
  vec3 directionTexture; // per mm
};

// The scalar at a position in the volume texture (folder Voxels).
float ScalarAt(vec3 positionTexture);

// The mapper's files of gradients read their values by this name.
vec4 TexelForDifference(vec3 positionTexture)
{
  return vec4(ScalarAt(positionTexture));
}

// The part of the distant light that arrives at the origin of a ray, [0, 1] (folder Shadow).
float Arriving(Ray ray);
// The colour that a material of this colour sends towards the eye (folder Look).
vec3 LitColor(vec3 color, float arriving, vec3 positionTexture, Ray ray);

bool HasGradient(vec3 positionTexture)
{
  return true;
}

vec3 TextureOfGrid(vec3 positionGrid)
{
  return (positionGrid + 0.5) * voxelCountInverse;
}

// The direction away from the eye, of one mm in the world.
vec3 AwayFromEye(vec3 positionGrid)
{
  vec3 away = positionGrid * eyeGrid.w - eyeGrid.xyz;
  return away / length(worldFromGrid * away);
}
