// The parameters of a march that belong to one volume, read by both marchers like those of
// RayParameters.glsl. Scalars are texture values for shaders, and values of the data for the
// processor. "Scale and bias" map x to x * scale + bias.

layout(std140) uniform VolumeParameters
{
  mat3 worldFromGrid;     // for directions only [mm]
  vec3 voxelCountInverse; // 1 / voxelCount
  vec3 firstVoxelGrid;    // first voxel in the volume texture; 0 if it holds the whole volume
  vec3 voxelCount;        // number of voxels in the volume texture along each axis

  // Steps by a field of bricks, cells or voxels.
  vec3 fieldSize;        // number of bricks, cells or voxels along each axis
  vec3 fieldSizeInverse; // 1 / fieldSize
  vec2 scalarFromField;  // scale and bias, from the number of a brick of extremes to a scalar
  float cellsPerBrick;   // number of cells along each side of a brick
  float sense;           // 1 for a maximum, -1 for a minimum

  // Transfer functions: up to four tables, and up to four components.
  vec4 tableScales;       // scale from a scalar to the index in its table
  vec4 tableBiases;       // bias from a scalar to the index in its table
  vec4 lastTableIndices;  // last index of each table
  vec4 firstEntries;      // first entry of each table in opticalTable
  vec4 visibleLower;      // a component absorbs nothing up to this scalar
  vec4 visibleUpper;      // a component absorbs nothing from this scalar on
  vec4 emissionBelow;     // emission and extinction [1/mm] below the scalars of preIntegratedTable
  vec4 emissionAbove;     // emission and extinction [1/mm] above them
  vec2 placeFromScalar;   // scale and bias, from the first value to [0, 1] in its range
  vec2 placeFromSecond;   // scale and bias, from the second value to [0, 1] in its range
  vec2 twoValueTableSize; // number of entries of twoValueTable along each axis, >= 2
  float placePerGradient; // scale from a gradient's magnitude to [0, 1] in its range
  float labelPart;        // weight of the labels' transfer functions, [0, 1]

  // Materials; if a volume has one component, its entry is 0.
  mat3 worldFromGradient; // from a gradient in the grid to a normal in the world, of any length
  vec3 diffuseLight;      // sum of the diffuse colours of the lights at the eye
  vec3 specularLight;     // sum of their specular colours
  vec3 dampingFactors;    // factors of a gradient; light is damped if the result is shorter than 1
  vec3 spacingFactors;    // mean spacing over twice the spacing along each axis
  vec4 opacityUnitDistancesMm; // distance in which a material reaches its opacity [mm]
  vec4 entriesPerGradient;     // scale from a gradient's magnitude to the index in its table
  vec4 partWeights;            // weight of each material in their mixture
  float lastGradientEntry;     // last index of a table of gradient opacity
  float clippedScalar;         // scalar that gradients see beyond clipping planes
  int isosurfaceCount;
  float backsLit;         // 1 if both sides of surfaces are lit, else 0
  float labelGradient;    // factor of a label's gradient, which makes it one that is not damped
  float scatteredPart;    // part of the light that matter scatters, [0, 1]
  float anisotropy;       // mean cosine of the angle by which it turns light, inside (-1, 1)
  float surfacesInShadow; // part of what matter takes from a light that surfaces lack, [0, 1]
  float shadowReachMm;    // distance beyond which matter casts no shadow [mm]
  float skyStrength;      // strength of ambient occlusion, (0, 1]; 0 without it
  float skyReachMm;       // distance beyond which matter does not occlude [mm]
  float skyStepMm;        // longest segment of rays to all sides [mm]
  float skyMostDepth;     // optical depth beyond which these rays let nothing through
  float skyPlacesMm;      // distance of such places along a ray, a multiple of stepMm [mm]
  int mostSkyPlaces;      // places of a ray with such rays; others keep the light of the last one
  vec4 reflectances[4];   // coefficients of ambient, diffuse and specular light, specular power

  // The mixture, and lights that are not at the eye.
  int materialCount;      // number of materials, 1 to 4
  int distantCount;       // number of distant lights, which come first in lightTexels
  int nearCount;          // number of near lights
  mat3 gridFromWorld;     // for directions only [1/mm]
  vec3 ambientLight;      // light that the ambient coefficient multiplies, of all lights
  vec3 worldOfGridOrigin; // world position of the grid's origin [mm]
  vec3 originInCasters;   // position of that origin in casterTree, which has the world's axes [mm]

  // Projections.
  vec4 smallestScalars; // smallest value of each component
  vec4 largestScalars;  // largest value of each component
  vec4 grayPerScalars;  // 1 / (largest - smallest value), or 0 if these are equal
  vec4 averagedLower;   // smallest scalar that counts in an average
  vec4 averagedUpper;   // largest scalar that counts in an average
  vec3 colorScale;      // scale from components that are colours to [0, 1]
  vec3 colorBias;       // bias from components that are colours to [0, 1]

  // Gaps and masks.
  vec4 gapOptical;          // colour, not premultiplied, and extinction [1/mm] of gaps
  float leastContent;       // a voxel is drawn if its content in the mask is greater than this
  float gapShift;           // 0 if the cells of gapTexture lie between voxels, 0.5 if around them
  vec3 gapCellCount;        // number of these cells along each axis
  vec3 gapCellCountInverse; // 1 / gapCellCount
  vec3 maskVoxelCount;      // number of voxels of the mask along each axis
  vec3 maskVoxelsPerVoxel;  // voxels of the mask per voxel of the volume

  // Voxels that are unevenly spaced; see Spacing/Uneven.glsl.
  vec3 spacingFirstBins;   // first bin of each axis in spacingTable
  vec3 spacingLastBins;    // last bin of each axis
  vec3 spacingLowerGrid;   // beginning of the first bin of each axis
  vec3 spacingBinsPerGrid; // number of bins per unit of the grid
  vec3 spacingVoxelCount;  // number of voxels of the whole volume along each axis

  // Slices: the surface of all positions with dot(p, sliceMatrix * p) = 0, where p is
  // (position - sliceCenterGrid, 1).
  mat4 sliceMatrix; // symmetric
  vec3 sliceCenterGrid;

  // One of several overlapping volumes.
  vec3 ownLowerGrid;    // lower corner of the visible box of this volume
  vec3 ownUpperGrid;    // upper corner of that box
  mat4 ownGridFromRays; // from the grid of the rays to that of this volume
};
