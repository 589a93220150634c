// The contract, of a volume: what the files of slots that belong to it may use, and what they must
// define. In a shader of several volumes that overlap this file stands once for each of them, and
// the files of the volume follow it. All that these declare is then the volume's own: the assembler
// gives the names of all volumes but the last an ending of their own. A name that ends with Before
// means that of the volume before.

int labelRow; // row of the label that a mask has where the ray is; 0 for none

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

// --- Components: only where a volume has several components -----------------------------------
// Of the materialCount materials that are mixed it defines
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

// --- Damping: only with light ------------------------------------------------------------------
// The part of diffuse and specular light that is left at a gradient, [0,1].
float LitPart(vec3 gradient);

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

// --- Gaps: where the volume has a value
// ----------------------------------------------------------- Whether all voxels are finite that a
// gradient there is made of.
bool HasGradient(vec3 positionTexture);

// --- Reading: only where several volumes overlap ------------------------------------------------
// Defines startValues, endValues, startGradients and endGradients of a segment of the volume's own
// ray, and what reads them:
//   void BeginReading(Ray ray, float t);     the ray, which begins at t
//   float NextReadingFace(float t);          where, behind t, a segment must end [mm]
//   void ReadValues(Ray ray, Interval segment);
//   void ReadGradients(Ray ray, Interval segment, bool isNext);
//                               isNext: those where the segment begins were read at its end before
