// The contract of the slots that belong to one volume: the variables and functions that their files
// may use, and what they must define.
//
// A shader of several overlapping volumes contains this file and the files of these slots once for
// each volume. The assembler then renames all that the files of a volume declare, for all volumes
// but the last. A name that ends in Before means that of the volume before.
//
// Texels and scalars are texture values, to which tables and thresholds are scaled.

int labelRow = 0; // row of the mask's label on this part of the ray, in tables; 0 without a label

vec3 PositionGrid(Ray ray, float t)
{
  return ray.originGrid + t * ray.directionGrid;
}

vec3 PositionTexture(Ray ray, float t)
{
  return ray.originTexture + t * ray.directionTexture;
}

// --- Spacing: the positions of voxels ---
// The position in the volume texture, for one in the even grid, in which rays are straight.
vec3 VoxelPlace(vec3 positionTexture);

// --- Filter: values between texels ---
// The trilinear mean of the texels around a place in a texture, which goes from 0 to 1; beyond the
// outermost texels it is that at the face. If voxels are boxes, the nearest texel.
vec4 Filtered(sampler3D volume, vec3 place);

// --- Difference: values between texels that are only subtracted from others ---
// Like Filtered, for values that are subtracted from those of places whole voxels away.
vec4 FilteredForDifference(sampler3D volume, vec3 place);

// --- Interpolation: values between voxels ---
// The values of up to four components.
vec4 TexelAt(vec3 positionTexture);
// The same for a value that is subtracted from those of positions whole voxels away.
vec4 TexelForDifference(vec3 positionTexture);
// The value of the first component.
float ScalarAt(vec3 positionTexture);
// The derivatives per voxel along an axis, which is (1, 0, 0), (0, 1, 0) or (0, 0, 1). Only
// Interpolation/CubicSpline.glsl defines it.
vec4 SlopeAlong(vec3 axis, vec3 positionTexture);

// --- Probe: fetches voxels, and may count the fetches ---
// The texel at a position in the volume texture. Every fetch of the volume is done here.
vec4 StoredAt(vec3 placeTexture);
// The same for a value that is subtracted from those of places whole voxels away.
vec4 StoredForDifference(vec3 placeTexture);
// Counts the fetch of another texture of the volume, if fetches are counted.
void CountFetch();
// The colour to draw for a ray that has gathered this colour.
vec4 Probed(vec4 picture);

// --- Step: the next segment of a ray ---
// Segment number `index` of a ray that is marched up to t [mm]. It begins beyond t if nothing
// before can be seen. It has the length plainMm, or more where the volume allows it; Jitter
// shortens the first segment. blendState is the result of BlendState for the ray up to t.
Interval NextSegment(Ray ray, Interval inside, float t, int index, float plainMm, float blendState);

// The segment from t on, of the length plainMm, or more where the volume allows it. It begins
// beyond t if nothing before can be seen. Not for extremes.
Interval NextOfField(Ray ray, Interval inside, float t, float plainMm);

// --- Classify: transfer functions ---
// Each function returns a colour (r,g,b), not premultiplied, and an extinction [1/mm]. A file
// defines the one that its march or its material calls.
// The look of a scalar.
vec4 Classify(float scalar);
// The mean look of a part of a ray along which the scalar changes linearly.
vec4 ClassifyBetween(float startScalar, float endScalar);
// The look of a scalar by one of several tables.
vec4 ClassifyBy(int table, float scalar);

// --- ClassifyTwo: a transfer function of two values, with results as those of Classify ---
// The look of two values, each [0,1] in its range.
vec4 ClassifyTwo(vec2 place);

// --- Components: the materials of several components. Only if a volume has several ---
// Defines, for materials 0 to materialCount - 1:
//   vec4 PartOptical(vec4 texel, int part);
//     The colour and extinction [1/mm] of a material.
//   int OpacityComponent(int part);
//     The component that determines the opacity of a material.
//   vec4 MoreExtreme(vec4 best, vec4 texel, float sense);
//     The larger values for sense 1, the smaller ones for -1.

// --- Gradient: only if light or opacity depends on it ---
// Twice the gradient per voxel, along the axes of the grid: the differences between values one
// voxel to either side.
vec3 GradientAt(vec3 positionTexture);
// The same for all components, a column for each.
mat4x3 GradientsAllAt(vec3 positionTexture);

// --- Shade: light on a sample. Only if a surface or a material may be lit ---
// The colour that a material of this colour sends towards the eye from t. reflectance has the
// coefficients of ambient, diffuse and specular light, and the specular power.
vec3 Shade(vec3 color, vec3 gradient, vec4 reflectance, Ray ray, float t);

// --- Through: what the volume absorbs along a ray that begins anywhere. Only for Around ---
// The optical depth of a part of a ray. It may change labelRow.
float DepthAlong(Ray ray, Interval inside, ShadowMarch march);
// The same for a ray of a few segments, which does not look for invisible bricks: it takes several
// segments in each iteration of its loop, because llvmpipe bounds the iterations of a shader.
float DepthNear(Ray ray, Interval inside, ShadowMarch march);

// --- Around: what lies around a place. Only for Reach and Sky ---
// The optical depth of everything from the origin of a ray on. It may change labelRow.
float DepthAround(Ray ray, ShadowMarch march);

// --- Reach: the part of each light that reaches a point. Only for Shade/Lights.glsl ---
// Parts of up to eight lights, in the order of lightTexels, [0,1].
struct Reach
{
  vec4 first;
  vec4 second;
};
// The parts at t. Along a ray, t should ascend.
Reach ReachAt(Ray ray, float t);
// The part of one light.
float Reaching(Reach reach, int light);
// The part of a light that surfaces receive where this part of it reaches.
float ReachingSurfaces(float reaching);

// --- Cone: the directions that a light comes from. Only for Reach/ShadowRays.glsl ---
// The part of a light that reaches a place, as a mean over its directions.
// @param towards  unit vector to the middle of the light, in the world
// @param farMm  distance of the light
// @param coneHeight  1 - the cosine of half its angle
float MeanTransmitted(vec3 originGrid, vec3 towards, float farMm, float coneHeight);
// The part that comes along one direction, by Reach/ShadowRays.glsl.
float Transmitted(vec3 originGrid, vec3 towards, float farMm);

// The way from a place to the middle of a light, by Reach/ShadowRays.glsl.
struct WayToLight
{
  vec3 towards; // unit vector, in the world
  float farMm;  // its length
};
WayToLight WayTo(vec3 placeOfLight, bool isDistant, vec3 originGrid);

// --- Casters: opaque geometry between lights and the volume. Only for Reach/ShadowRays.glsl ---
// The parts of the lights that geometry leaves. Lights that are cones have lost theirs already.
Reach LeftByCasters(Reach reach, vec3 originGrid);
// True if no geometry lies on a way.
bool CastersLeave(vec3 originGrid, vec3 towards, float farMm);

// --- Scatter: the light that goes from a point to the eye. Only for Shade/Lights.glsl ---
// The diffuse and the specular part of a light.
// @param reflected  the parts that a surface reflects of it
// @param litPart  see LitPart
// @param reaching  the part of the light that reaches the point
vec2 SentToEye(vec2 reflected, float litPart, vec3 toLight, vec3 toEye, float reaching);
// The factor of the sum over all lights.
float PartOfSent(float litPart);

// --- Damping: less light where a volume is homogeneous. Only with light ---
// The fraction of diffuse and specular light that remains at a gradient, [0,1].
float LitPart(vec3 gradient);

// --- GradientOpacity: opacity depends on the gradient ---
// The extinction [1/mm] of a material, for its extinction by value alone. `component` is the number
// of the material, or the row of a label.
float AtGradient(float extinction, vec3 gradient, int component);

// --- LabelLight: light on a sample that may have a label. Only with labels ---
// Defines:
//   vec3 LitLabel(vec3 color, vec3 gradient, Ray ray, float t);
//     The color after lighting, for a gradient of the scalars.

// The gradient of the part of space that the row's label fills, per voxel; 0 inside of it. Only
// LabelLight/Labels.glsl defines it.
vec3 GradientOfLabel(vec3 positionGrid);

// --- Values: what the material at a point depends on ---
// Defines struct Values, which is read at every sample, and struct Gradients, which is read only
// where a sample absorbs light. Both can be taken as linear along a short segment.
//   Values ValuesAt(vec3 positionTexture);
//   Gradients GradientsAt(vec3 positionTexture);
//   Values Between(Values start, Values end, float along);
//   Gradients Between(Gradients start, Gradients end, float along);
//     Linear interpolation, with `along` in [0,1].
//   Values WithAdded(Values values, float scalar);
//     The values with a number added to the first scalar, or to each of several components. Only
//     for Outside.
//   bool MayAbsorb(Values start, Values end);
//     True if any value between the two may absorb light.

// --- Rows: the looks of the rows of a label map. Only with labels ---
// Defines:
//   vec4 OfRow(int row, Values values, Gradients gradients);
//     The colour before lighting and the extinction [1/mm].

// --- Material: the look of a point. Only if it depends on more than one scalar ---
// Defines:
//   vec4 Material(Values values, Gradients gradients, vec4 kept, Ray ray, float t);
//     The colour after lighting, not premultiplied, and the extinction [1/mm]. kept has the part of
//     its light that each material keeps, see Sky; a single one has the first.
//   float MaterialExtinction(Values values, Gradients gradients);
//     The extinction alone [1/mm].

// --- Outside: the places from which surfaces see what is around them. Only for Sky/OpenSky.glsl
// --- Defines:
//   int SurfaceCount();
//     The number of surfaces that a position may have, one for each material.
//   bool HasSurface(int material, Values values, Gradients gradients);
//     True if the material may be near the position.
//   vec3 OwnWayOutside(int material, Values values, Gradients gradients, vec3 positionGrid);
//     The way from a position on the surface of a material to this place [grid], 0 where there is
//     no surface.

// --- Sky: light from all around, as far as matter lets it through. Only for materials ---
// Defines:
//   vec4 KeptOf(Values values, Gradients gradients, vec3 positionGrid);
//     The part of its light that each material keeps at a position, [0,1]; a single one has the
//     first.
//   vec4 KeptAt(Ray ray, float t);
//     The same at t. Along a ray, t should ascend: segments shorter than skyPlacesMm share a place.

// --- Gaps: see also Slots.glsl ---
// True if the volume has a value at this position.
bool HasValue(vec3 positionTexture);
// True if all voxels that the gradient at this position depends on are finite.
bool HasGradient(vec3 positionTexture);

// --- Reading: reads the segments of one volume. Only if several volumes overlap ---
// Defines the variables startValues, endValues, startGradients and endGradients of a segment along
// the volume's own ray, and the functions that set them:
//   void BeginReading(Ray ray, float t);
//     Begins a ray at t.
//   float NextReadingFace(float t);
//     The next t at which a segment must end [mm].
//   void ReadValues(Ray ray, Interval segment);
//   void ReadGradients(Ray ray, Interval segment, bool isNext);
//     isNext is true if the gradients at the beginning of the segment were the last to be read.
//   vec4 KeptIn(Ray ray, Interval segment);
//     The part of their light that the materials keep in the segment, see KeptOf.
