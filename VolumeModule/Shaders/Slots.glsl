// The contract of the shaders: the types that every file may use, and what the file of each slot
// must define. VolumeSlots.glsl goes on with the slots that belong to one volume.
//
// main() in RayMarch.frag.glsl makes the ray of a pixel and calls DrawnRay (slot Resume). A march
// then goes inwards, each slot with the parts of the ray that the one before leaves:
// MarchCropped (Crop) -> MarchMasked (Mask) -> MarchVolume (Gaps) -> March (March).
//
// Spaces: *grid* has voxel (i,j,k) at (i,j,k). *Texture* has the volume texture, which holds the
// volume or one block of it, in [0,1] on each axis. *World* is the scene, with lengths in mm.
// Extinction is in 1/mm; optical depth is extinction times length, without a unit.

// A ray through the volume: position(t) = origin + t * direction. t is a length in the world [mm].
struct Ray
{
  vec3 originGrid;
  vec3 directionGrid; // per mm
  vec3 originTexture;
  vec3 directionTexture; // per mm
};

// The part of a ray with t from enter to exit [mm]; empty unless enter < exit.
struct Interval
{
  float enter;
  float exit;
};

// How far and how exactly a ray to a light is marched.
struct ShadowMarch
{
  float farMm;     // distance beyond which matter does not count [mm]
  float firstMm;   // first segment [mm]
  float longestMm; // longest segment [mm]
  float mostDepth; // optical depth beyond which no light is left
  bool isNear;     // true for a ray of a few segments, which does not look for invisible bricks
};

// --- Pixel: the place of the ray in its image, from the lower left corner [pixels] ---
vec2 RayPixel();

// --- Depth: opaque geometry ends rays ---
// The t at which geometry that is already drawn ends the ray of this pixel [mm]; without any, a
// value beyond every exit.
float DepthLimit(Ray ray);
// The weight of a ray of a coarse image, one with fewer rays than pixels, in this pixel, (0, 1]. It
// is small if that ray ends at another surface.
float Trust(Ray ray, Interval inside, ivec2 coarsePixel);

// --- Clip: clipping planes shorten rays ---
// The part of the ray that all planes leave.
Interval Clipped(Ray ray, Interval inside);
// True if a plane cuts the position away. Only Clip/Planes.glsl defines it.
bool IsClipped(vec3 positionGrid);

// --- Span: where rays begin, and how far they go ---
// The part of the ray that is marched.
Interval Spanned(Ray ray, Interval inside);
// The part of the ray inside a box that near and far plane, opaque geometry and clipping planes
// leave.
Interval InsideBox(Ray ray, vec3 lowerGrid, vec3 upperGrid);

// --- Jitter: noise shortens the first segment of a ray ---
// The length of the first segment, as a fraction of the length of the others, (0, 1].
float FirstSegment();
// The length of segment number `index` [mm], if the others have the length plainMm.
float PlainMm(int index, float plainMm);

// --- Blend: a ray's samples become a colour ---
// Defines struct Accumulation, the state of a ray, and these functions:
//   Accumulation BlendBegin();
//     The state before the first sample.
//   Accumulation BlendPart(Accumulation sum, vec3 color, float depth);
//     Composites: adds the next part of the ray, of this colour and optical depth.
//   Accumulation BlendScalar(Accumulation sum, float scalar, float lengthMm);
//     Projections: adds the next part of the ray, along which the volume has this scalar.
//   Accumulation BlendTexel(Accumulation sum, vec4 texel, float lengthMm);
//     Projections of several components: the same.
//   float BlendState(Accumulation sum);
//     The number that slot Step needs. Composites: the transmittance, [0, 1]. Extremes: the largest
//     or smallest scalar so far.
//   bool BlendFinished(Accumulation sum);
//     True if nothing that follows could be seen.
//   vec4 BlendResult(Accumulation sum);
//     The colour of the ray, premultiplied RGBA.
//   vec4 BlendKept(Accumulation sum);
//     The state in four floats, to be stored in a texture; 0 before the first sample.
//   Accumulation BlendResumed(vec4 kept);
//     The inverse of BlendKept.

// --- Sample: reads a sample and adds it. Only for March/Projection.glsl ---
// Defines:
//   Accumulation BlendSample(Accumulation sum, vec3 positionTexture, float lengthMm);

// --- Volumes: the sum of overlapping volumes. Only if several volumes overlap ---
// Defines functions of this volume and of all volumes before it in the shader (VolumeSlots.glsl):
//   Interval BeginVolumes(Ray ray, Interval inside);
//     Begins a ray. Returns the part of it from the first volume to the last.
//   float NextFace(float t);
//     The next t at which a volume, or a voxel drawn as a box, begins or ends [mm].
//   Interval NextVisible(float t, int index, float blendState);
//     The next part of the ray, from t on, in which anything may be visible and all looks the same.
//   bool ReadSegment(Interval segment);
//     Reads the next segment, which crosses no face. Returns true if anything in it may absorb
//     light. A segment without length only reads the values at its position.
//   Mixture MixtureOf(Interval segment);
//     Emission and extinction of the segment that was read last; see Volumes/None.glsl.
// and, for rays to lights, one that Around/Volumes.glsl defines:
//   float DepthOfVolumes(vec3 originWorld, vec3 directionWorld, ShadowMarch march);
//     The optical depth of their boxes from the origin of a ray on.

// --- Loop, March: the loop along a ray, and the rule of integration in it ---
// Each file of Loop declares what the file of March defines for it. Some files of March have a loop
// of their own and use none of Loop. Together they define:
//   Accumulation March(Ray ray, Interval inside, Accumulation sum);
//     Adds a part of the ray in which the volume has values.

// --- Fill: the look of gaps, where the volume has no value. Only if there are gaps ---
// Defines:
//   Accumulation FillGap(Accumulation sum, float lengthMm);
//     Adds a part of the ray that lies in a gap.

// --- Gaps: divides rays where the volume has no value ---
// Defines:
//   Accumulation MarchVolume(Ray ray, Interval inside, Accumulation sum);
//     Marches the parts of the ray that have a value, and fills the gaps between them.

// --- Crop: divides rays at cropping planes ---
// True if the region at t is drawn.
bool IsDrawn(Ray ray, float t);
// Defines:
//   Accumulation MarchCropped(Ray ray, Interval inside, Accumulation sum);
//     Marches the parts of the ray that lie in visible regions.

// --- Window: window and level of the image ---
// The colour to draw, for a colour that a ray has gathered; both are premultiplied RGBA.
vec4 Windowed(vec4 picture);

// --- Peel: layers of translucent geometry divide rays. Only for depth peeling ---
// The two parts of the ray to draw, as depths of the depth buffer: the part in front of layers from
// x to y, and the part behind layers from z to w. A part is empty unless x < y, or z < w.
vec4 PeeledDepths();
// The colour to draw for the colours of both parts. Another output may take that of the front.
vec4 Peeled(vec4 front, vec4 back);

// --- Locate: the colour of the position that FirstOpacity.glsl finds ---
vec4 ColorOfPlace(vec3 positionGrid);

// --- Mask: divides rays where the content of a mask changes ---
// The row of the mask's label at a position, in tables; 0 without a label, -1 where the mask hides
// the volume.
int LabelRowAt(vec3 positionGrid);
// Defines:
//   Accumulation MarchMasked(Ray ray, Interval inside, Accumulation sum);
//     Marches the parts of the ray that the mask shows, and sets labelRow for each.

// --- Resume: the beginning and the end of the march in one drawing ---
// The colour to draw for a ray. It comes from a march of the whole ray or of one block, or from an
// image that was drawn before.
vec4 DrawnRay(Ray ray, Interval inside);
