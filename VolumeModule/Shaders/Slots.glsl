// The contract: what every slot file may use, and what it must define.
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

uniform vec2 viewportOriginPixels; // of the renderer in its framebuffer
uniform mat3 worldFromGrid;        // directions only
uniform float stepMm;              // the sample distance
uniform int mostSegments;          // a ray has no more, so that every frame ends
uniform sampler3D volumeTexture;
// Rows of clipFromGrid that give clip z and w: the surface of equal depth is a plane in the grid.
uniform vec4 clipDepthRow;
uniform vec4 clipWeightRow;
uniform vec3 firstVoxelGrid; // of the volume texture; 0 where it holds the whole volume

vec3 PositionTexture(Ray ray, float t)
{
  return ray.originTexture + t * ray.directionTexture;
}

// --- Spacing: where voxels are -----------------------------------------------------------------
// The place in the texture of one in the even grid that rays are straight in.
vec3 VoxelPlace(vec3 positionTexture);

// --- Interpolation: what lies between voxels ---------------------------------------------------
// The scalars there, of up to four components: texture values, which tables and thresholds are
// scaled to.
vec4 TexelAt(vec3 positionTexture);
// The scalar of a volume of one component.
float ScalarAt(vec3 positionTexture);
// Of a spline, the derivative along an axis (1, 0, 0), (0, 1, 0) or (0, 0, 1), per voxel.
vec4 SlopeAlong(vec3 axis, vec3 positionTexture);

// --- Probe: observes the work of a ray -------------------------------------------------------
// What is stored at a place in the texture. Every reading of the volume goes through here.
vec4 StoredAt(vec3 placeTexture);
// What is drawn for a ray that has made this picture.
vec4 Probed(vec4 picture);

// --- Depth: where opaque geometry ends a ray ------------------------------------------------
// t of the geometry already drawn at this pixel, or a value beyond every exit [mm].
float DepthLimit(Ray ray);

// --- Clip: which part of a ray clipping planes leave ------------------------------------------
Interval Clipped(Ray ray, Interval inside);
// Whether they cut a place away; only where there are planes.
bool IsClipped(vec3 positionGrid);

// --- Jitter: where a ray has its first sample ------------------------------------------------
// Length of the first segment of a ray, as a part of the others' (0, 1].
float FirstSegment();
// Length of a segment where nothing tells a better one [mm].
float PlainMm(int index, float plainMm);

// --- Step: which part of the ray comes next --------------------------------------------------
// The segment that follows t, the index-th of its ray [mm]. It may begin later, where nothing
// between can be seen, and ends after t: at plainMm, or farther where the volume allows it.
// blendState: what BlendState tells of the ray so far.
Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState);

// --- Classify: what a scalar looks like ----------------------------------------------------
// Colour (r,g,b), not premultiplied, and extinction [1/mm]. A file defines one of these two, as its
// march needs it.
vec4 Classify(float scalar);
// Means over a piece of ray along which the scalar goes linearly from one value to another.
vec4 ClassifyBetween(float startScalar, float endScalar);

// Of several tables, one.
vec4 ClassifyBy(int table, float scalar);
// Of two values, each [0,1] in its range.
vec4 ClassifyTwo(vec2 place);

// --- Count, Components: only where a volume has several components ----------------------------
// Count defines PartCount, the number of materials that are mixed. Components defines
//   vec4 PartOptical(vec4 texel, int part);    colour and extinction of one
//   int OpacityComponent(int part);            the component that its opacity is of
//   vec4 MoreExtreme(vec4 best, vec4 texel, float sense);
//                                              the larger values (sense 1), or the smaller (-1)

// --- Gradient: only where light or opacity depend on it -----------------------------------------
// In texels of the volume per voxel, along the axes of the grid.
vec3 GradientAt(vec3 positionTexture);
// A column for each component.
mat4x3 GradientsAllAt(vec3 positionTexture);

// --- Shade: light at a sample; only where there is a material -----------------------------------
// What is emitted at t by a material of this color. reflectance: coefficients of ambient, diffuse
// and specular light, and the specular power.
vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t);

// --- GradientOpacity: where opacity depends on the gradient -----------------------------------
// The extinction [1/mm] of a component, from that without a gradient.
float AtGradient(float extinction, vec3 gradient, int component);

// --- Values: what of a point its material depends on ---------------------------------------------
// Defines what is read of the volume at a point, struct Values, and, only where it absorbs
// anything, struct Gradients; both can be taken as linear over a short piece of ray:
//   Values ValuesAt(vec3 positionTexture);
//   Gradients GradientsAt(vec3 positionTexture);
//   Values Between(Values start, Values end, float along);            along in [0,1]
//   Gradients Between(Gradients start, Gradients end, float along);
//   bool MayAbsorb(Values start, Values end);                         anything between the two

// --- Material: what a point looks like, where more than one scalar tells -------------------------
// Defines:
//   vec4 Material(Values values, Gradients gradients, Ray ray, float t);
//                               colour as it is lit, not premultiplied, and extinction [1/mm]

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

// --- Voxel: what a voxel without interpolation adds; only for March/Voxels --------------------
// Defines: Accumulation BlendVoxel(Accumulation sum, vec3 middleTexture, Ray ray, float lengthMm);

// --- Surface: what isosurfaces look like; only where they are drawn -----------------------------
// Defines the number of them, isosurfaceCount, and, for each, by ascending isovalue:
//   float IsovalueOf(int surface);
//   bool IsPassed(int surface, float startScalar, float endScalar);
//   Accumulation BlendSurface(Accumulation sum, int surface, vec3 gradient, Ray ray, float t);

// --- March: the loop along a ray, with its rule of integration --------------------------------
// Defines: Accumulation March(Ray ray, Interval inside, Accumulation sum);
//                               takes in the part of the ray that is inside

// --- Fill: what is drawn where the volume has no value; only where there are gaps ---------------
// Takes in a part of the ray, of this length.
//   Accumulation FillGap(Accumulation sum, float lengthMm);

// --- Gaps: the parts of a ray where the volume has a value -------------------------------------
// Whether all voxels are finite that a gradient there is made of.
bool HasGradient(vec3 positionTexture);
// Defines, after all the others: Accumulation MarchVolume(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that have a value

// --- Region: what is drawn of a mask's voxels; only where there is a mask -----------------------
// Whether voxels of this content are drawn; then what follows is drawn by it.
//   bool EntersRegion(float content);

// --- Crop: which parts of a ray cropping leaves -------------------------------------------------
// Defines, after all the others: Accumulation MarchCropped(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that are left

// --- Window: what is done to the colours of a picture ------------------------------------------
vec4 Windowed(vec4 picture);

// --- Edges: only where a picture is drawn with fewer rays than pixels --------------------------
uniform vec2 coarsePerPixel; // rays per pixel on each axis
// How far the ray through this pixel of those is to be trusted for this one, (0, 1].
float Trust(Ray ray, Interval inside, ivec2 coarsePixel);

// --- Peel: only between layers of translucent geometry -----------------------------------------
// What is seen of the volume between two depths of the depth buffer.
vec4 Segment(Ray ray, Interval inside, float frontDepth, float backDepth);

// --- Locate: only where a place along a ray is asked for ----------------------------------------
// Defines: const float Nowhere; and
//   float FirstWithOpacity(Ray ray, Interval inside, float opacity);
//                               t where the ray first has this opacity, or Nowhere [mm]

// --- Mask: the parts of a ray that a mask tells apart -------------------------------------------
// Defines, after all the others: Accumulation MarchMasked(Ray ray, Interval inside, Accumulation
// sum);
//                               marches through all parts that are drawn

// --- Resume: where rays begin and end, with a volume in one block or in several ------------------
// What is drawn for a ray.
vec4 DrawnRay(Ray ray, Interval inside);
