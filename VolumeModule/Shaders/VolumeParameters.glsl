// The numbers of a march that belong to one volume; as RayParameters.glsl. A scalar is what the
// marcher reads: shaders a texture value, the processor a value of the data.

layout(std140) uniform VolumeParameters
{
  mat3 worldFromGrid;     // directions only
  vec3 voxelCountInverse; // of the volume texture
  vec3 firstVoxelGrid;    // of the volume texture; 0 where it holds the whole volume
  vec3 voxelCount;        // of the volume texture

  // Steps by a field of bricks or cells.
  vec3 fieldSize; // bricks or cells along each axis
  vec3 fieldSizeInverse;
  vec2 scalarFromField; // scale and bias: number of an extreme brick -> scalar
  float cellsPerBrick;
  float sense; // of an extreme: 1 for a maximum, -1 for a minimum

  // Up to four tables of transfer functions, and up to four components.
  vec4 tableScales; // scalar -> index in its table
  vec4 tableBiases;
  vec4 lastTableIndices;
  vec4 firstEntries; // of each table in the buffer of all
  vec4 visibleLower; // a component absorbs nothing up to this scalar
  vec4 visibleUpper; // and from this one on
  vec4 opticalBelow; // color and extinction of the scalars below those of a pre-integrated table
  vec4 opticalAbove;
  vec2 placeFromScalar; // scale and bias: scalar -> [0, 1] in the range of a function of two values
  vec2 placeFromSecond;
  vec2 twoValueTableSize; // at least two along each axis
  float placePerGradient;
  float labelPart; // weight of the transfer functions of labels, [0, 1]

  // Materials; those of one component have entry 0.
  mat3 worldFromGradient; // a gradient per voxel -> a normal in the world, any length
  vec3 diffuseLight;      // colors of the lights at the eye
  vec3 specularLight;
  vec3 dampingFactors; // a gradient -> its part of that at which light is whole
  vec3 spacingFactors; // mean spacing over twice the spacing along each axis
  vec4 opacityUnitDistancesMm;
  vec4 entriesPerGradient; // gradient -> index in the table of gradient opacity
  vec4 partWeights;        // weight of each component in their mixture
  float lastGradientEntry; // of a table of gradient opacity
  float clippedScalar;     // stands for what clipping planes have cut away
  int isosurfaceCount;
  float backsLit;       // 1: both sides of a surface are lit
  vec4 reflectances[4]; // coefficients of ambient, diffuse and specular light, specular power

  // Lights that are not at the eye.
  int materialCount; // materials that are mixed
  int distantCount;  // of lights; these come first
  int nearCount;
  vec3 ambientLight; // of all lights
  vec3 worldOfGridOrigin;

  // Projections.
  vec4 smallestScalars; // range of each component
  vec4 largestScalars;
  vec4 grayPerScalars;
  vec4 averagedLower; // range of the scalars that count in an average, both ends included
  vec4 averagedUpper;
  vec3 colorScale; // components that are colors -> these
  vec3 colorBias;

  // Gaps and masks.
  vec4 gapOptical;    // color, not premultiplied, and extinction [1/mm] where there is no value
  float leastContent; // voxels of more than this content of a mask are drawn
  float gapShift;     // 0 where cells lie between voxels, 0.5 where they are voxels
  vec3 gapCellCount;
  vec3 gapCellCountInverse;
  vec3 maskVoxelCount;
  vec3 maskVoxelsPerVoxel;

  // Voxels at uneven places.
  vec3 spacingFirstBins; // of each axis, in the table
  vec3 spacingLastBins;
  vec3 spacingLowerGrid; // where the first bin begins
  vec3 spacingBinsPerGrid;
  vec3 spacingVoxelCount;

  // Slices.
  mat4 sliceMatrix;     // symmetric; the slice is where dot(p, sliceMatrix * p) = 0, with
  vec3 sliceCenterGrid; // p = (position from here, 1)

  // One of several volumes that overlap.
  vec3 ownLowerGrid; // of what is drawn of this volume
  vec3 ownUpperGrid;
  mat4 ownGridFromRays;
};
