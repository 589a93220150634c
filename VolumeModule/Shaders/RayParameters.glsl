// The parameters of a march that do not belong to one of its volumes. Both marchers read them:
// shaders as a uniform block, the processor as the struct that Core/Parameters/MarchParameters.h
// makes of this file. Members that every step reads come first (Core/Recipe/ShaderAssembly.h). No
// scalar follows a vec3, so that C++ and std140 agree on the position of each member.

layout(std140) uniform RayParameters
{
  float stepMm;                        // sample distance [mm], > 0
  int mostSegments;                    // limit on the segments of a ray, so that every frame ends
  float earlyTerminationTransmittance; // a ray ends when less light than this passes, [0, 1)
  int clippingPlaneCount;              // number of planes in clippingPlanes

  // Lower left corner of the image in its framebuffer, minus the offset of its rays [pixels].
  vec2 viewportOriginPixels;
  ivec2 noisePixelsMask; // width and height of noiseTexture, powers of two, minus 1 [pixels]

  // Lower and upper cropping plane of x, y and z [grid]. The dot product with (position, 1) is >= 0
  // above a plane.
  vec4 croppingPlanes[6];
  // Bit x + 3 y + 9 z is set if the region is drawn. Each of x, y, z is 0 below the planes of its
  // axis, 1 between them, and 2 above them. 0 without cropping.
  int croppingRegions;

  float shadowStepMm;  // longest segment of rays to lights, and distance between them [mm]
  int clampDepth;      // 1: a ray that meets nothing visible has the depth of its exit
  float leastOpacity;  // opacity from which a ray is picked or has a depth, [0, 1]
  float sameSurfaceMm; // distance of the ends of two rays that end at one surface [mm]
  // Rows of clipFromGrid for z and w of clip space. A surface of equal depth is a plane in the
  // grid.
  vec4 clipDepthRow;
  vec4 clipWeightRow;
  vec2 depthPixelsPerPixel; // pixels of depthTexture per pixel of the image, along each axis
  vec2 windowScaleBias;     // scale and bias of colours, by window and level
  vec2 coarsePerPixel;      // pixels of coarseTexture per pixel of the image, along each axis
  ivec2 lastCoarsePixel;    // upper right pixel of coarseTexture
  int raysPerSide;          // rays along each side of a pixel, if there are more rays than pixels
  int marchedColumns;       // width of the image that the processor has marched [pixels]
  int marchedPixels;        // number of pixels of that image
  float imageCount;         // number of complete images in sumTexture
  int rowsOfNext;           // number of rows, from below, in which sumTexture has one more image
  int pickedHighestBits;    // 1: picking writes the bits of a number above its lowest 24; 0: those
  float pickedOffset;       // index of a point or cell = floor(grid position + this)
  float firstDistanceMm;    // distance from the eye at which a ray begins, if not before the volume
  float spanMm;             // length of the part of a ray that is marched [mm]
  float samplesAfterHit;    // number of samples of March/FirstHit.glsl

  // The ray of a pixel at (x, y), each in [-1, 1]: element 0 + x * element 1 + y * element 2. The
  // start is in homogeneous coordinates (Core/Geometry/PixelRays.h).
  vec4 rayStartGrid[3];
  vec3 rayDirectionGrid[3];
  vec4 nearPlaneGrid;         // the dot product with (position, 1) is >= 0 beyond the near plane
  vec4 farPlaneGrid;          // the dot product with (position, 1) is >= 0 up to the far plane
  vec3 boxLowerGrid;          // lower corner of the box that rays are marched in
  vec3 boxUpperGrid;          // upper corner of that box
  vec3 wholeLowerGrid;        // lower corner of the box of the whole volume
  vec3 wholeUpperGrid;        // upper corner of that box
  vec3 eyeGrid;               // position of the camera
  vec3 sharedUpperGrid;       // upper faces at which another block begins; elsewhere far away
  vec3 propColor;             // colour that stands for this volume in a selection, [0, 1]
  vec3 pickedCount;           // number of points or cells along each axis
  vec2 viewportPixelsInverse; // 1 / width and 1 / height of the image [1/pixels]
  mat4 clipFromGrid;
};
