// The contract: what every slot file may use, and what it must define. What belongs to the volume
// stands in VolumeSlots.glsl.
//
// Spaces: *grid* has voxel (i,j,k) at (i,j,k); *texture* has the volume texture, which holds the
// volume or a block of it, in [0,1];
// *world* is the scene, its lengths in mm.

// A ray through the volume. position(t) = origin + t * direction; t is a world length [mm].
struct Ray
{
  vec3 originGrid;
  vec3 directionGrid; // per mm
  vec3 originTexture;
  vec3 directionTexture; // per mm
};

// Part of a ray that is inside the volume, t from enter to exit [mm].
struct Interval
{
  float enter;
  float exit;
};

// --- Depth: where opaque geometry ends a ray ------------------------------------------------
// t of the geometry already drawn at this pixel, or a value beyond every exit [mm].
float DepthLimit(Ray ray);
// Where an image is drawn with fewer rays than pixels: how far the ray of one of these coarse
// pixels is to be trusted for this pixel, (0, 1].
float Trust(Ray ray, Interval inside, ivec2 coarsePixel);

// --- Clip: which part of a ray clipping planes leave ------------------------------------------
Interval Clipped(Ray ray, Interval inside);
// Whether they cut a place away; only where there are planes.
bool IsClipped(vec3 positionGrid);

// --- Jitter: where a ray has its first sample ------------------------------------------------
// Length of the first segment of a ray, as a part of the others' (0, 1].
float FirstSegment();
// Length of a segment where nothing tells a better one [mm].
float PlainMm(int index, float plainMm);

// --- Blend: what the samples of a ray become -----------------------------------------------
// Defines struct Accumulation, and:
//   Accumulation BlendBegin();
//   Accumulation BlendPart(Accumulation sum, vec3 color, float depth);
//                               composite: takes in the next part of the ray, of that color and
//                               optical depth
//   Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm);
//                               projection: takes in the next part of the ray, of one scalar
//   Accumulation BlendTexel(Accumulation sum, vec4 texel, float lengthMm);
//                               the same, of several components
//   float BlendState(Accumulation sum);      what steps depend on. Composite: the part of what
//                               follows that is still seen, [0,1]; extremes: the scalar so far
//   bool BlendFinished(Accumulation sum);    nothing that follows could be seen
//   vec4 BlendResult(Accumulation sum);      premultiplied RGBA
//   vec4 BlendKept(Accumulation sum);        the sum in four floats, 0 at the beginning
//   Accumulation BlendResumed(vec4 kept);    and the sum again

// --- Sample: what a sample adds; only for March/Projection ------------------------------------
// Defines: Accumulation BlendSample(Accumulation sum, vec3 positionTexture, float lengthMm);

// --- Volumes: only where several volumes overlap ------------------------------------------------
// Defines what all volumes so far in the shader are together; see VolumeSlots.glsl:
//   Interval BeginVolumes(Ray ray, Interval inside);
//                               once for each ray: the part of it that they have
//   float NextFace(float t);    where, behind t, something begins or ends [mm]
//   Interval NextVisible(float t, int index, float blendState);
//                               where, not before t, anything may be seen, and how far from there
//                               it looks the same [mm]
//   bool ReadSegment(Interval segment);
//                               reads the next segment, between two faces; whether anything in it
//                               may absorb light. One of no length makes its place known
//   Mixture MixtureOf(Interval segment);     what is in it, after it was read

// --- Loop, March: the loop along a ray, and its rule of integration ---------------------------
// The files of Loop say what those of March define for them. A file of March that has a loop of its
// own takes none. Together they define:
//   Accumulation March(Ray ray, Interval inside, Accumulation sum);
//                               takes in the part of the ray that is inside

// --- Fill: what is drawn where the volume has no value; only where there are gaps ---------------
// Takes in a part of the ray, of this length.
//   Accumulation FillGap(Accumulation sum, float lengthMm);

// --- Gaps: the parts of a ray where the volume has a value -------------------------------------
// Defines, after all the others: Accumulation MarchVolume(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that have a value

// --- Crop: which parts of a ray cropping leaves -------------------------------------------------
// Defines, after all the others: Accumulation MarchCropped(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that are left

// --- Window: what is done to the colours of a picture ------------------------------------------
vec4 Windowed(vec4 picture);

// --- Peel: only between layers of translucent geometry -----------------------------------------
// Which parts of a ray are drawn, as depths of the depth buffer: one in front of some layers, from
// x to y, and one behind others, from z to w; there is none where these are not in order.
vec4 PeeledDepths();
// What is drawn by the colours of both; that of the front one beside it.
vec4 Peeled(vec4 front, vec4 back);

// --- Locate: what is drawn for the place where a ray first has an opacity (FirstOpacity.glsl)
// --------
vec4 ColorOfPlace(vec3 positionGrid);

// --- Mask: the parts of a ray that a mask tells apart -------------------------------------------
// Defines, after all the others: Accumulation MarchMasked(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that are drawn

// --- Resume: where rays begin and end, with a volume in one block or in several ------------------
// What is drawn for a ray.
vec4 DrawnRay(Ray ray, Interval inside);
