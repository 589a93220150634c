// The numbers of a march that do not belong to one of its volumes. Both marchers read them: shaders
// as a uniform block, the processor as the struct that Core/Parameters/MarchParameters.h makes of
// this file. Members that every step reads come first (Core/Recipe/FlatParameters.h). A scalar
// never follows a vec3: then C++ and std140 agree on where each member lies.

layout(std140) uniform RayParameters
{
  float stepMm;                        // sample distance
  int mostSegments;                    // limit on the segments of a ray, so that every frame ends
  float earlyTerminationTransmittance; // a ray ends where less light than this passes
  int clippingPlaneCount;
  vec2 viewportOriginPixels; // of the frame in its framebuffer, less the offset of rays
  ivec2 noisePixelsMask;     // size of the noise, powers of two, less 1
  vec4 croppingPlanes[6];    // grid space; lower and upper plane of x, y and z
  int croppingRegions;       // bit x + 3 y + 9 z: the region is drawn; 0, 1, 2: below, between and
                             // above the planes of an axis
  int clampDepth;            // 1: a ray that meets nothing visible has the depth of its exit
  float leastOpacity;        // from this opacity on a ray is picked, or has a depth
  float sameSurfaceMm;       // rays whose ends are this near end at one surface
  vec4 clipDepthRow;         // rows of clipFromGrid that give clip z and w: the surface of equal
  vec4 clipWeightRow;        // depth is a plane in the grid
  vec2 depthPixelsPerPixel;  // pixels of the depth texture per pixel of the frame
  vec2 windowScaleBias;      // of colors
  vec2 coarsePerPixel;       // rays per pixel of a frame that is drawn with fewer rays
  ivec2 lastCoarsePixel;
  int raysPerSide;          // of a pixel of a frame that is drawn with more rays
  int marchedColumns;       // of an image that the processor has marched
  int marchedPixels;        // of all of it
  float imageCount;         // complete images in the accumulated sum
  int rowsOfNext;           // rows, from below, of which the sum holds one more image
  int pickedHighestBits;    // 1: the bits above the lowest 24 are asked for
  float pickedOffset;       // in the grid: a point lies at its number, a cell half behind it
  vec4 rayStartGrid[3];     // homogeneous start of a ray, affine in the pixel's position
  vec3 rayDirectionGrid[3]; // likewise its direction; Core/Geometry/PixelRays.h
  vec4 nearPlaneGrid;       // dot(plane, position) >= 0 beyond the near plane
  vec4 farPlaneGrid;        // and before the far plane
  vec3 boxLowerGrid;        // box that rays are marched in
  vec3 boxUpperGrid;
  vec3 sharedUpperGrid; // upper faces at which another block begins; elsewhere far away
  vec3 propColor;       // stands for this volume in a selection
  vec3 pickedCount;     // points or cells along each axis
  vec2 viewportPixelsInverse;
  mat4 clipFromGrid;
};
