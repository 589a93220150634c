/**
 * @class   vtkVariationFieldVolumeMapper
 * @brief   A volume mapper that ray marches and skips what hardly varies, within an error tolerance
 *
 * A direct vtkVolumeMapper for vtkImageData and vtkRectilinearGrid with one to four components of
 * point or cell data, of any scalar type. It marches rays through the volume. An acceleration field
 * tells how far a ray may go before the volume changes by more than a tolerance; the mapper takes
 * that stretch in one step and integrates emission and absorption over it in closed form, instead
 * of sampling it.
 *
 * Rays are marched by a fragment shader or, on a software OpenGL such as Mesa's llvmpipe, by
 * vectorized C++ code on all cores (see ProcessorMarching). Both follow the same rules.
 *
 * Use it like any other volume mapper:
 * @code
 *   vtkNew<vtkVariationFieldVolumeMapper> mapper;
 *   mapper->SetInputConnection(reader->GetOutputPort());
 *   volume->SetMapper(mapper);
 * @endcode
 *
 * World lengths are taken to be mm, as in medical data; any other unit works as long as
 * vtkVolumeProperty::SetScalarOpacityUnitDistance uses it too. Lengths are measured in world space,
 * so a volume that is scaled by its matrix becomes thicker.
 *
 * All seven blend modes of vtkVolumeMapper are drawn: composite, maximum, minimum and average
 * intensity, additive, isosurface and slice. Each has VTK's meaning, in the limit of a sample
 * distance that tends to 0.
 *
 * Transfer functions mean what GetValue() and GetColor() of VTK's classes return, limited to [0,
 * 1], with all of their flags but colours of annotated values (IndexedLookup), which VTK's volume
 * mappers ignore too, and NaN colours. The opacity of a unit distance is multiplied by the gradient
 * opacity at the magnitude of the central differences per mean spacing. As in VTK, a quarter of the
 * range of all finite values is the largest such magnitude; the function at it holds beyond.
 *
 * Voxels that are not finite (NaN, infinity) have no value. Cells that touch one are transparent,
 * unless NanOpacity is above 0, and do not count in projections. Next to them only ambient light
 * applies. Volumes without such voxels pay nothing for this.
 *
 * Shading uses all lights that are on, at their positions, and one-sided or two-sided lighting as
 * the renderer is set. A surface faces the side where the values fall. Ambient light is that of the
 * lights, as in VTK, except that it is white if there are only head lights.
 *
 * A vtkHardwareSelector selects the volume, and the point or cell at which a ray becomes half
 * opaque or, if it never does, the first one that is visible. Translucent geometry inside the
 * volume is composited correctly if vtkRenderer::SetUseDepthPeeling and
 * SetUseDepthPeelingForVolumes are on.
 *
 * User code replaces a slot of the shader through the volume's vtkShaderProperty. A slot is a
 * folder of VolumeModule/Shaders; its contract is in Slots.glsl there:
 * @code
 *   volume->GetShaderProperty()->AddFragmentShaderReplacement("//Varimarch::Window", true,
 *     "vec4 Windowed(vec4 picture) { return picture.bgra; }", false);
 * @endcode
 * The vtkShaderProperty's custom fragment uniforms are declared for this code, and the mapper
 * invokes vtkCommand::UpdateShaderEvent before each drawing. The acceleration fields do not know
 * user code: set AccelerationModeToOff if it shows what the transfer function hides.
 *
 * The camera's clipping range cuts the volume at its near and far planes.
 *
 * Independent components form a mixture: their extinctions and emissions, each multiplied by the
 * component's weight, add up, in any order. A maximum or minimum adds colour and opacity that each
 * component has over its unit distance, up to 1; averages and sums are weighted. Of two dependent
 * components the first gives the colour and the second the opacity. Of four, the first three are
 * red, green and blue, scaled by 255, by the largest value of a 16 bit type, or by 1 for
 * floating-point types, and the fourth gives the opacity. Shading uses the gradient of the first
 * component.
 *
 * Interpolation follows the property, whose default in VTK is nearest: voxels are then boxes of
 * constant value and are drawn exactly. Isosurfaces are exact too, and so are slices by a function
 * of at most second degree, such as a vtkPlane or vtkSphere. Sample distance and error tolerance do
 * not affect them. CubicInterpolation replaces linear interpolation by a spline.
 *
 * A rectilinear grid is interpolated between its own coordinates. CellField and VariationField
 * are not available for it.
 *
 * Several inputs are the volumes of a vtkMultiVolume. They may overlap, and are drawn as one
 * composite of the sum of their extinctions and emissions, each with its own matrix, property and
 * voxels. Set them up with vtkVariationFieldGPUVolumeRayCastMapper, because vtkMultiVolume asks a
 * vtkGPUVolumeRayCastMapper for its bounds. Overlapping volumes exclude masks, cropping, blanked or
 * non-finite voxels, cuts drawn as surfaces, a number of steps, user code, depth images and drawing
 * in blocks.
 *
 * An isosurface of several independent components is that of the component with the largest weight.
 *
 * These features are not supported and reported as errors: isosurfaces of dependent components or
 * with CubicInterpolation; rectilinear grids with isosurfaces, blanking, masks or
 * CubicInterpolation.
 *
 * Numbers without a meaning are replaced, and a warning names them once: NaN, which VTK's setters
 * accept, by the default of the setting, and a number out of its range by the nearest one, in
 * lights, the property and the mapper. A lamp without a finite place and a plane without a finite
 * normal are left out. A volume, a camera, an isovalue or a transfer function that is not finite,
 * and a matrix without an inverse, are reported as errors, and nothing is drawn.
 *
 * @sa vtkVariationFieldGPUVolumeRayCastMapper vtkVolumeProperty
 */

#ifndef vtkVariationFieldVolumeMapper_h
#define vtkVariationFieldVolumeMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkSmartPointer.h"       // For MaskInput
#include "vtkVolumeMapper.h"

#include <memory> // For Internals
#include <string> // For ReportOnce

class vtkImageData;
class vtkInformationDoubleKey;
class vtkInformationIntegerKey;
class vtkStringArray;

namespace varimarch
{
class SharedSearch;
}

class VARIMARCHVOLUME_EXPORT vtkVariationFieldVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkVariationFieldVolumeMapper* New();
  vtkTypeMacro(vtkVariationFieldVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // How rays sample the volume and the image.

  enum AccelerationModes
  {
    Off,            ///< no field: all steps have the sample distance
    CellField,      ///< blocks of cells in which values differ by at most VariationTolerance
    VariationField, ///< the field published by Banquero, Ortiz and Rossi (2016), for comparison
    OpticalField    ///< the field of the colours and opacities that the transfer function gives
  };

  ///@{
  /**
   * The field by which rays skip samples. OpticalField knows the transfer function: rays leave
   * invisible parts at once and cross parts of constant look in one step, with an error of at most
   * 1/255 in a premultiplied colour channel. For a maximum or minimum, rays skip what cannot change
   * the extreme found so far; sums and averages skip only if they include all scalar values.
   * VariationField is for linear interpolation only. It stores for each voxel the distance to the
   * nearest voxel whose value differs by VariationTolerance or more, and a ray takes steps of that
   * length. With PublishedSum this is the method that its authors published. Default: OpticalField.
   */
  vtkSetClampMacro(AccelerationMode, int, Off, OpticalField);
  vtkGetMacro(AccelerationMode, int);
  void SetAccelerationModeToOff() { this->SetAccelerationMode(Off); }
  void SetAccelerationModeToCellField() { this->SetAccelerationMode(CellField); }
  void SetAccelerationModeToVariationField() { this->SetAccelerationMode(VariationField); }
  void SetAccelerationModeToOpticalField() { this->SetAccelerationMode(OpticalField); }
  ///@}

  ///@{
  /**
   * If OpenGL runs on the CPU, as Mesa's llvmpipe does, march rays in C++, in packets of rays,
   * instead of in a shader. This is two to ten times as fast and follows the same rules, except
   * that several components, overlapping volumes and rectilinear grids are integrated by midpoints
   * only. It is fastest with AVX2. Default: on.
   *
   * Shaders still draw what packets do not support: slices; masks of other dimensions than the
   * volume; transfer functions of two arrays; shaded volumes with non-finite values; user code;
   * isosurfaces, averages and sums with nearest interpolation; and extremes, averages and sums of
   * several components or of rectilinear grids, or with RenderToImage. They also draw with a limit
   * set by MaximumGraphicsMemory.
   *
   * With a graphics card too, packets draw Shadows, AmbientOcclusion and scattered light that the
   * volume dims. They keep light from one image to the next, and need no shader, which takes
   * seconds to compile.
   *
   * Packets read 8 and 16 bit integers and finite floats in place. Voxels of several components, of
   * other types, or with non-finite values are copied first.
   */
  vtkSetMacro(ProcessorMarching, vtkTypeBool);
  vtkGetMacro(ProcessorMarching, vtkTypeBool);
  vtkBooleanMacro(ProcessorMarching, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Largest difference between two values in a block that a ray may cross in one step, in units of
   * the scalars. Affects CellField and VariationField only. A negative value means 1/256 of the
   * scalars' range. Default: -1.
   */
  vtkSetMacro(VariationTolerance, double);
  vtkGetMacro(VariationTolerance, double);
  ///@}

  enum IntegrationRules
  {
    Automatic,     ///< Midpoint, or PreIntegrated if it keeps the error tolerance in less time
    Midpoint,      ///< second order: the segment has the value in its middle
    PreIntegrated, ///< values are linear between samples, the transfer function is exact
    Simpson,       ///< extinction is a parabola through three samples
    PublishedSum,  ///< the sum of repeated samples of Banquero, Ortiz and Rossi (2016)
    FirstHit       ///< MaximumNumberOfSteps samples behind the first of opacity above one half
  };

  ///@{
  /**
   * The rule that integrates a composite between samples. If opacity or colour depend on gradients
   * or on several values, as shaded colours do, there are two rules: Midpoint, and one that is
   * linear between samples and takes four parts per segment, which PreIntegrated and Simpson then
   * mean. For these materials Automatic without an error tolerance is the latter, and PublishedSum
   * and FirstHit, which are not defined for them, are an error; so they are for nearest
   * interpolation and back to front. FirstHit searches in steps of an eighth of the sample
   * distance, and draws nothing in front of what it finds. Default: Automatic.
   */
  vtkSetClampMacro(IntegrationRule, int, Automatic, FirstHit);
  vtkGetMacro(IntegrationRule, int);
  ///@}

  ///@{
  /**
   * Largest accepted error of a pixel, in a premultiplied RGBA channel before the background is
   * added, 0 to 1. Default: 1/64. While it is above 0 and AutoAdjustSampleDistances is on, the
   * mapper chooses sample distance, integration rule, field tolerance and early termination such
   * that 99.9 % of the pixels keep it and none exceeds twice this value. For 0, the sample distance
   * and EarlyTerminationTransmittance have their own values.
   *
   * The error is estimated from a few thousand rays of each new view, at random places. In a nearby
   * view of a moving camera a thousand rays confirm the last steps; if they do not, other steps are
   * searched for. This costs 10 to 20 % of a frame's time. It is an estimate, not
   * a proof: it may miss rays that just graze a hard surface, or a peak of opacity that is too
   * narrow for any sample. A tolerance that 128 samples per voxel cannot keep is reported as a
   * warning, and so is one that takes more than some seconds to search for because volumes dim
   * light; GetErrorToleranceIsKept then returns false. An observer of vtkCommand::AbortCheckEvent
   * of the window may stop the search, and an image of packets, at any time.
   */
  vtkSetClampMacro(ErrorTolerance, double, 0.0, 1.0);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * Distance between samples along a ray [world units, mm], > 0. Default: 1. Used only while
   * AutoAdjustSampleDistances is off. The volume's diagonal has at most 20000 samples in shaders,
   * 10000 if they are shaded, and 80000 in packets; a shorter distance is lengthened to that, with
   * a warning.
   */
  vtkSetClampMacro(SampleDistance, double, 1e-30, 1e30);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Distance between samples along a ray in voxels: in units of the smallest spacing. If it is
   * above 0, it replaces SampleDistance. Default: 0.
   */
  vtkSetClampMacro(SampleDistanceInVoxels, double, 0.0, 1e30);
  vtkGetMacro(SampleDistanceInVoxels, double);
  ///@}

  ///@{
  /**
   * Number of sample distances after which a ray ends, from where it enters the volume or, inside
   * of it, from the camera's near plane or FirstDistance on. For FirstHit, the number of samples.
   * Ignored while AutoAdjustSampleDistances is on, because the sample distance is not known then.
   * Not available for overlapping volumes. 0 is no limit. Default: 0.
   */
  vtkSetClampMacro(MaximumNumberOfSteps, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Distance from the eye at which rays begin [world units, mm], for a camera inside the volume:
   * what is nearer is not drawn. With a parallel projection it is the distance from the plane of
   * the camera's position. Default: 0.
   */
  vtkSetClampMacro(FirstDistance, double, 0.0, 1e30);
  vtkGetMacro(FirstDistance, double);
  ///@}

  ///@{
  /**
   * Set SampleDistance for each frame to VTK's choice for the input's spacing: half the mean
   * spacing, less for volumes of few voxels (vtkVolumeMapper::SpacingAdjustedSampleDistance).
   * Affects only frames drawn while AutoAdjustSampleDistances is off. Default: off.
   */
  vtkSetClampMacro(LockSampleDistanceToInputSpacing, vtkTypeBool, 0, 1);
  vtkGetMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
  vtkBooleanMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Let the mapper choose the sample distance: from the error tolerance or, if that is 0, as a
   * fraction of the smallest voxel spacing in the world. Default: on.
   */
  vtkSetClampMacro(AutoAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(AutoAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(AutoAdjustSampleDistances, vtkTypeBool);
  ///@}

  ///@{
  /**
   * A ray ends when less than this fraction of the light behind it would reach the eye, which is
   * also the largest error of a premultiplied channel that this makes. Range [0, 1). Default:
   * 1/1024. Not used while an error tolerance is in effect.
   */
  vtkSetClampMacro(EarlyTerminationTransmittance, double, 0.0, 0.999999);
  vtkGetMacro(EarlyTerminationTransmittance, double);
  ///@}

  enum CompositingOrders
  {
    FrontToBack, ///< rays may end early and skip what is invisible
    BackToFront  ///< whole rays at equal steps, for comparison
  };

  ///@{
  /**
   * The order in which the samples of a ray are composited. Both give the same image up to rounding
   * and early termination. BackToFront takes neither a field nor early termination, integrates by
   * midpoints, and is left to shaders. It applies to composites; overlapping volumes and voxels
   * drawn as boxes are always composited front to back. Default: FrontToBack.
   */
  vtkSetClampMacro(CompositingOrder, int, FrontToBack, BackToFront);
  vtkGetMacro(CompositingOrder, int);
  void SetCompositingOrderToFrontToBack() { this->SetCompositingOrder(FrontToBack); }
  void SetCompositingOrderToBackToFront() { this->SetCompositingOrder(BackToFront); }
  ///@}

  ///@{
  /**
   * Use a tricubic spline through the voxels where the property asks for linear interpolation. All
   * voxels keep their values and edges show no staircase, but next to a sharp edge the spline
   * overshoots, by up to a tenth of the step. Shading uses the spline's gradient. Each sample costs
   * eight fetches, and each voxel takes four bytes of graphics memory and as much main memory. Not
   * available for rectilinear grids, isosurfaces and non-finite voxels. Default: off.
   */
  vtkSetClampMacro(CubicInterpolation, vtkTypeBool, 0, 1);
  vtkGetMacro(CubicInterpolation, vtkTypeBool);
  vtkBooleanMacro(CubicInterpolation, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Keep the gradients of all voxels in a texture of 6 bytes per voxel, instead of computing each
   * from six fetches. The image is the same but for the rounding of the gradients to 16 bits.
   * Applies to volumes of one component where the image needs gradients, unless these are those of
   * a spline, see clipping planes as surfaces, or belong to a rectilinear grid. Such images are
   * left to shaders. Default: off.
   */
  vtkSetClampMacro(StoredGradients, vtkTypeBool, 0, 1);
  vtkGetMacro(StoredGradients, vtkTypeBool);
  vtkBooleanMacro(StoredGradients, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Offset the first sample of each ray by blue noise, which is the same in all frames. The rings
   * that a long sample distance causes become fine grain. Default: off.
   */
  vtkSetClampMacro(UseJittering, vtkTypeBool, 0, 1);
  vtkGetMacro(UseJittering, vtkTypeBool);
  vtkBooleanMacro(UseJittering, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Distance between rays on the screen [pixels], 0.1 to 100. Default: 1, one ray per pixel. With a
   * larger distance, pixels between rays are interpolated, but not across edges of opaque geometry.
   * With a smaller one, rounded to 1/2, 1/3 and so on, a pixel is the mean of its rays.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Range of the image sample distance [pixels] that the mapper chooses from during interaction.
   * Interaction means: AutoAdjustSampleDistances is on and the volume's allocated render time is
   * below 1 s, as with a desired update rate above 1 per second. The mapper then uses fewer rays
   * and up to four times the error tolerance, depending on the time the last frames took. The first
   * frame without interaction has full quality. Defaults: 1 and 10.
   */
  vtkSetClampMacro(MinimumImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Largest number of frames that are averaged while the scene does not change. Each Render() then
   * shifts the rays inside their pixels, from the second frame on with a quarter of the error
   * tolerance, and shows the mean of all frames so far: edges become smooth. Call Render() until
   * GetAccumulatedPictures() returns this number; further calls add none. A change of anything
   * visible begins again. Frames are not averaged during interaction, with an ImageSampleDistance
   * other than 1, or if UpdateShaderEvent has an observer. A mapper averages those of one renderer
   * and one eye: others that are drawn in turn begin again. Default: 1, off.
   */
  vtkSetClampMacro(MaximumAccumulatedPictures, int, 1, 65536);
  vtkGetMacro(MaximumAccumulatedPictures, int);
  ///@}

  ///@{
  /**
   * Time limit of one Render() while the scene does not change [s]. Pixels that are not finished by
   * then are shown at low resolution, and the next Render() continues, so that a program stays
   * responsive. Call Render() until GetDrawnPart() returns 1. A change of anything visible begins
   * again. There is no limit for frames that cannot be accumulated (see MaximumAccumulatedPictures)
   * and for volumes drawn in blocks. Default: 0, no limit.
   */
  vtkSetClampMacro(LongestPartSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestPartSeconds, double);
  ///@}

  // A vtkVolumeProperty has no missing values, no light that the volume dims, and no masks.

  ///@{
  /**
   * Colour and opacity, each in [0, 1], of cells that touch a non-finite voxel (NaN or infinity). A
   * composite draws them as a homogeneous, unshaded material with this opacity over one
   * vtkVolumeProperty::ScalarOpacityUnitDistance; all other blend modes leave them out. The names
   * are those of vtkLookupTable. The NaN colours of the property's functions are not used, because
   * they are opaque by default. Defaults: opacity 0, colour (0.5, 0, 0).
   */
  vtkSetVector3Macro(NanColor, double);
  vtkGetVector3Macro(NanColor, double);
  vtkSetClampMacro(NanOpacity, double, 0.0, 1.0);
  vtkGetMacro(NanOpacity, double);
  ///@}

  ///@{
  /**
   * A gradient magnitude below which diffuse and specular light are reduced in proportion.
   * A homogeneous material, whose gradient is noise, then keeps only its ambient light, and
   * surfaces stand out. Units: scalar value per mean voxel spacing, as for gradient opacity.
   * Applies to volumes of one component. Default: 0, no reduction. Source: Volt (2009).
   */
  vtkSetClampMacro(DampingGradient, double, 0.0, 1e30);
  vtkGetMacro(DampingGradient, double);
  ///@}

  ///@{
  /**
   * Let the volume cast shadows on itself, and overlapping volumes on each other: the diffuse and
   * specular light of each of the renderer's first eight lights that are not at the eye is
   * multiplied by what the volumes between the light and the sample let through. Ambient light and
   * lights at the eye cast none. Requires a composite with shading; volumes without shading cast
   * shadows on others. The error tolerance holds for the image with its shadows, which takes about
   * three times as long as without and, where shaders draw it, many times as long. The light that
   * reaches the visible parts is kept while the volume, its look and a light stay, in up to an
   * eighth of a byte for each voxel and light. Packets of rays on the processor draw
   * those of a volume that does not fit into the graphics memory (see ProcessorMarching). Default:
   * off.
   *
   * Opaque geometry casts shadows on the volume too: the faces of the renderer's visible actors,
   * also in assemblies and outside the view, as far as their mappers' clipping planes leave them.
   * Translucent actors, lines, points, wireframes, glyphs, a vtkSkybox and representations of
   * widgets cast none (actors of a vtk3DWidget do), nor does a prop with the key CASTS_SHADOWS set
   * to 0, nor more than two million triangles, nor a vtkDataSetMapper of other data than polygons
   * before its first drawing, nor does geometry take away scattered light without Shadows.
   *
   * The same faces receive the shadows of the renderer's volumes: the colours that VTK has drawn
   * are multiplied by the part of their light that is left, also those of lines or glyphs that lie
   * on a face. Several volumes with mappers of their own leave their common shadow. The steps of
   * that light are found for it, so that it keeps the error tolerance. Images during interaction
   * have as many places of light as rays of the volume (see MinimumImageSampleDistance). Behind
   * translucent geometry, peeled or not, what that adds keeps its light; it is drawn twice then.
   * With RenderToImage the faces in the window are dimmed. A volume that has been drawn once with
   * shadows and geometry keeps casting them when it leaves the view: it adds a vtkCuller to the
   * renderer, so that vtkFrustumCoverageCuller does not leave it out. Shader code of the user, and
   * shaders for overlapping volumes or blocks, leave all that out. So does a renderer that shows a
   * volume of another mapper without depth peeling for volumes, or translucent geometry by a
   * vtkRenderPass of the caller or beside UseShadows. VTK lets geometry cast shadows on geometry
   * (vtkShadowMapPass).
   */
  vtkSetClampMacro(Shadows, vtkTypeBool, 0, 1);
  vtkGetMacro(Shadows, vtkTypeBool);
  vtkBooleanMacro(Shadows, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Strength of Shadows, [0, 1]: the part of what matter takes from a light that surfaces lack. At
   * 0 there are no shadows. Scattered light is dimmed by all of it. Default: 1.
   */
  vtkSetClampMacro(ShadowStrength, double, 0.0, 1.0);
  vtkGetMacro(ShadowStrength, double);
  ///@}

  /**
   * Softness of a light, a key of vtkLight::GetInformation() [degrees, 0 to 90]: half the angle of
   * the cone that it comes from. Its shadows are the mean over twelve directions in that cone
   * (Documentation/Mathematics.md) and take several times as long; highlights and scattering are
   * those of its middle. Without the key a light is a point.
   */
  static vtkInformationDoubleKey* LIGHT_SOFTNESS();

  /**
   * Whether a prop of opaque geometry casts shadows on volumes, a key of
   * vtkProp::GetPropertyKeys(): 0 if it casts none and receives none. Without the key it does.
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();

  ///@{
  /**
   * Part of the diffuse and specular light that matter scatters, once, instead of reflecting it,
   * [0, 2]; from 1 on all is scattered, as in VTK in the limit of short steps. Scattered light is
   * the colour times the diffuse coefficient times the phase function of Henyey and Greenstein,
   * whose mean over all directions is 1. Requires a composite with shading. Default: 0.
   */
  vtkSetClampMacro(VolumetricScatteringBlending, double, 0.0, 2.0);
  vtkGetMacro(VolumetricScatteringBlending, double);
  ///@}

  ///@{
  /**
   * Distance over which the volume dims light before it is scattered, [0, 1]. As in VTK it is
   * 1 - (1 - reach)^0.33 diagonals of the volume, and unlimited for 1. With Shadows it is unlimited
   * for all light. Lights at the eye are not dimmed. Default: 0.
   */
  vtkSetClampMacro(GlobalIlluminationReach, double, 0.0, 1.0);
  vtkGetMacro(GlobalIlluminationReach, double);
  ///@}

  ///@{
  /**
   * Mean cosine of the angle by which scattering turns light, limited to [-0.99, 0.99]: light goes
   * straight on near 1, back near -1, and to all sides alike at 0. Default: 0, which takes that of
   * the volume's property, since VTK 9.2.
   */
  vtkSetClampMacro(ScatteringAnisotropy, double, -1.0, 1.0);
  vtkGetMacro(ScatteringAnisotropy, double);
  ///@}

  ///@{
  /**
   * Strength of ambient occlusion, [0, 1]: how much darker a place is that sees little of what is
   * around the volume. With the part V of the light from all around that matter within
   * AmbientOcclusionReach lets through, all light of a sample is multiplied by
   * V / (V + strength (1 - V)): at 1 light is reflected once, below that matter also reflects the
   * light of other matter. V is that two voxels outside the surface of a sample
   * (Documentation/Mathematics.md); a box of voxels without interpolation has that of its middle,
   * and with LabelSurfaces a label has a surface of its own; so has each of several components,
   * where the component changes that determines its opacity. The error tolerance holds for the
   * image with its occlusion, which needs one: without a tolerance, and below 1/128, it takes very
   * long. For composites, lit or not. Packets of rays on the processor draw it where they can (see
   * ProcessorMarching), also with a graphics card, and keep the light while the volume and its look
   * stay, in up to a byte for each voxel. Shaders draw the rest, such as gaps beside gradients, but
   * not volumes that do not fit into graphics memory; they compute all light again in each image.
   * Without a graphics card they may have to stop behind translucent matter; the mapper then warns
   * that the tolerance may be missed. Images during interaction (see MinimumImageSampleDistance)
   * leave occlusion out. Default: 0, no occlusion.
   */
  vtkSetClampMacro(AmbientOcclusion, double, 0.0, 1.0);
  vtkGetMacro(AmbientOcclusion, double);
  ///@}

  ///@{
  /**
   * Distance beyond which matter does not occlude [mm]. Default: 0, which is 16 times the smallest
   * distance between voxels.
   */
  vtkSetClampMacro(AmbientOcclusionReach, double, 0.0, 1e30);
  vtkGetMacro(AmbientOcclusionReach, double);
  ///@}

  enum TypesOfMask
  {
    BinaryMaskType,
    LabelMapMaskType
  };

  ///@{
  /**
   * An image of one component that spans the same box as the volume, at any resolution; each mask
   * voxel fills the cube around it. Default: none. As in vtkGPUVolumeRayCastMapper, a binary mask
   * limits all blend modes to where it is above 0. A label map (the default type) gives voxels the
   * transfer functions of their label (vtkVolumeProperty::SetLabelColor, SetLabelScalarOpacity,
   * SetLabelGradientOpacity), for composites of volumes of one component. Labels may have any
   * value; a voxel whose label has no function is drawn as if it had no label.
   */
  void SetMaskInput(vtkImageData* mask);
  vtkImageData* GetMaskInput();
  vtkSetClampMacro(MaskType, int, BinaryMaskType, LabelMapMaskType);
  vtkGetMacro(MaskType, int);
  void SetMaskTypeToBinary() { this->SetMaskType(BinaryMaskType); }
  void SetMaskTypeToLabelMap() { this->SetMaskType(LabelMapMaskType); }
  ///@}

  ///@{
  /**
   * Weight of the label's functions, [0, 1]; the volume's own functions have the rest. Default: 1.
   */
  vtkSetClampMacro(MaskBlendFactor, float, 0.0f, 1.0f);
  vtkGetMacro(MaskBlendFactor, float);
  ///@}

  ///@{
  /**
   * Light voxels with a label as the surface of their label, so that a segment in tissue of its own
   * brightness is not dark. Inside a label the light is that of a surface that faces the eye.
   * Default: off, lit by the gradient of the scalars, as VTK does.
   */
  vtkSetMacro(LabelSurfaces, vtkTypeBool);
  vtkGetMacro(LabelSurfaces, vtkTypeBool);
  vtkBooleanMacro(LabelSurfaces, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Name of the point data array that is the second argument of a two-dimensional transfer function
   * (vtkVolumeProperty::SetTransferFunction2D). Default: none, which means the gradient magnitude,
   * measured as for gradient opacity. The first and last points on each axis of the function's
   * image are the ends of that argument's range.
   */
  vtkSetStringMacro(Transfer2DYAxisArray);
  vtkGetStringMacro(Transfer2DYAxisArray);
  ///@}

  // Images, memory and levels, and what is known of the last image.

  /**
   * Estimated error of the integration steps, by some rays of the last frame, in a premultiplied
   * channel [0, 1]: 99.9 % of the pixels are off by at most this. 0 without an error tolerance; 1,
   * the largest possible error, if nothing is known because the table of the transfer function
   * misses parts of it.
   */
  double GetEstimatedError();

  ///@{
  /**
   * For measurements: draw how often each ray has sampled the volume instead of its colour. The
   * count is written to the red channel, unscaled, and therefore needs a floating-point
   * framebuffer. Default: off.
   */
  vtkSetMacro(DrawFetchCounts, bool);
  vtkBooleanMacro(DrawFetchCounts, bool);
  vtkGetMacro(DrawFetchCounts, bool);
  ///@}

  /// The number of frames that the image on screen averages; 1 if off, 0 until the first is
  /// complete.
  int GetAccumulatedPictures();

  /// The finished fraction of all frames to be accumulated, [0, 1]; less than 1 while RefinedLevel
  /// goes on in any of the views that are drawn in turn, or voxels follow the means.
  double GetDrawnPart();

  /**
   * The image sample distance of the last frame [pixels].
   */
  double GetUsedImageSampleDistance();

  ///@{
  /**
   * Draw into two images instead of the window; both are as large as the renderer divided by the
   * image sample distance. The colour image is RGBA of unsigned char over transparent white. The
   * depth image holds depth-buffer values of the first visible point on each ray; a ray that meets
   * nothing has 1 or, with ClampDepthToBackface, the depth at which it leaves the volume. Integer
   * types scale depths to their range. GetColorImage and GetDepthImage return the last ones drawn.
   * Defaults: off, VTK_FLOAT.
   */
  vtkSetMacro(RenderToImage, vtkTypeBool);
  vtkGetMacro(RenderToImage, vtkTypeBool);
  vtkBooleanMacro(RenderToImage, vtkTypeBool);
  vtkSetMacro(DepthImageScalarType, int);
  vtkGetMacro(DepthImageScalarType, int);
  void SetDepthImageScalarTypeToUnsignedChar() { this->SetDepthImageScalarType(VTK_UNSIGNED_CHAR); }
  void SetDepthImageScalarTypeToUnsignedShort()
  {
    this->SetDepthImageScalarType(VTK_UNSIGNED_SHORT);
  }
  void SetDepthImageScalarTypeToFloat() { this->SetDepthImageScalarType(VTK_FLOAT); }
  vtkSetMacro(ClampDepthToBackface, vtkTypeBool);
  vtkGetMacro(ClampDepthToBackface, vtkTypeBool);
  vtkBooleanMacro(ClampDepthToBackface, vtkTypeBool);
  void GetColorImage(vtkImageData* image);
  void GetDepthImage(vtkImageData* image);
  ///@}

  ///@{
  /**
   * Map colours of the image from [FinalColorLevel - FinalColorWindow / 2, FinalColorLevel +
   * FinalColorWindow / 2] to [0, 1], before they are multiplied by opacity. A negative window
   * inverts them. Defaults: 1 and 0.5, which change nothing.
   */
  vtkSetMacro(FinalColorWindow, float);
  vtkGetMacro(FinalColorWindow, float);
  vtkSetMacro(FinalColorLevel, float);
  vtkGetMacro(FinalColorLevel, float);
  ///@}

  /**
   * The sample distance of the last frame [world units].
   */
  double GetUsedSampleDistance();

  /**
   * Time that the last build of the field took [s]; 0 before the first. It includes reading the
   * volume only if the volume was new.
   */
  double GetFieldBuildSeconds();

  ///@{
  /**
   * Limit of the graphics memory that this mapper takes [bytes]. Default: 0, what the device has. A
   * volume that does not fit, or that exceeds the device's largest 3D texture, is drawn in blocks:
   * those that fit stay in graphics memory, the others are uploaded each time they are drawn. A
   * volume that fits pays nothing for this. With shadows or ambient occlusion, and where volumes
   * overlap, packets of rays on the processor draw volumes that do not fit, and need no blocks (see
   * ProcessorMarching).
   */
  vtkSetClampMacro(MaximumGraphicsMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumGraphicsMemory, vtkIdType);
  ///@}

  ///@{
  /**
   * Level by which a volume that vtkVolumeFileReader has left in its file is drawn: its voxels, or
   * the means of cubes of 4 x 4 x 4 voxels (of more in very large volumes), which are in memory.
   * AutomaticLevel takes the means during interaction (see MinimumImageSampleDistance) and, with
   * LongestPartSeconds, for the first image of a scene, which is there at once. Volumes in memory,
   * overlapping ones, and those with a mask or blanked voxels are always drawn, and all are picked,
   * by their voxels.
   *
   * RefinedLevel begins with the means, and then knows their error. Each further image of the same
   * scene takes the levels of the file between the means and the voxels, and voxels, where the
   * means may change it most, as many as are read soon, until GetLevelErrorBound() is at most half
   * of the ErrorTolerance (of 1/64 if there is none), whose other half is for everything else.
   * Voxels that no pixel needs are never read: clear ones, those of one material, and hidden ones.
   * Shadows and ambient occlusion count; then voxels between what is seen and a light are read too,
   * where they may change it. Shadows of soft lamps near the volume do not. Images whose error
   * cannot be bounded so are drawn by voxels. Default: AutomaticLevel.
   */
  enum
  {
    VoxelLevel,
    CoarseLevel,
    AutomaticLevel,
    RefinedLevel
  };
  vtkSetClampMacro(LevelOfDetail, int, VoxelLevel, RefinedLevel);
  vtkGetMacro(LevelOfDetail, int);
  ///@}

  /**
   * Largest error of a premultiplied channel of any pixel of the last image, [0, 1], that the
   * coarse level can have caused; 0 for an image of the voxels. It follows from the ranges of
   * bricks, in about a second, for composites of the whole volume; for other images of the coarse
   * level it is 1, not known.
   */
  double GetLevelErrorBound();

  /**
   * The level of the last image: VoxelLevel, CoarseLevel or RefinedLevel.
   */
  int GetUsedLevelOfDetail();

  ///@{
  /**
   * The number of blocks of the volume that may be seen in the last image of RefinedLevel, and of
   * those among them that were drawn by their voxels; 0 for images of a single level.
   */
  vtkIdType GetVisibleBlocks();
  vtkIdType GetRefinedBlocks();
  ///@}

  /**
   * False if the voxels of a next image of RefinedLevel may not fit in half of the memory for them.
   * Since they would be read anew for each image, the next one takes all that it needs, and is the
   * last; it may take many times as long as its voxels are read.
   */
  bool GetNextRefinementFits();

  ///@{
  /**
   * Limit of the program's main memory while it draws a volume that vtkVolumeFileReader has left
   * in its file [bytes]. Beyond it, parts of the file that were not needed for the longest time are
   * dropped from memory. Default: 0, which leaves the limit as it is, at first that of the reader.
   */
  vtkSetClampMacro(MaximumHostMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumHostMemory, vtkIdType);
  ///@}

  /**
   * Graphics memory that this mapper holds now, textures and buffers [bytes].
   */
  vtkIdType GetGraphicsMemoryBytes();

  /**
   * Main memory for the light of shadows and ambient occlusion, of which only the visible parts are
   * taken from the system [bytes].
   */
  vtkIdType GetLightMemoryBytes();

  /**
   * True if the last frame keeps the ErrorTolerance everywhere, by some of its own rays. False if
   * steps cannot keep it, or if isolated rays graze an opaque surface; a warning then names the
   * error and the sample distance. False too while a larger error is accepted during interaction.
   */
  bool GetErrorToleranceIsKept();

  /**
   * Shader files of the last frame, one per slot, as paths below VolumeModule/Shaders; empty if
   * packets on the CPU have marched its rays.
   */
  void GetShaderParts(vtkStringArray* parts);

  ///@{
  /**
   * Number of times that each resource was built since this mapper was made.
   * Documentation/Architecture.md lists which change rebuilds which of them.
   */
  int GetVolumeTextureBuilds(); ///< uploads of new scalars
  int GetBlockUploads();        ///< uploads of the volume, or of the blocks it is drawn in
  int GetBrickRangesBuilds();
  int GetFieldBuilds(); ///< does not count the same field for other ray directions
  int GetOpticalTableBuilds();
  int GetLightLatticeBuilds();   ///< lattices that were begun, one for each light
  int GetGeometryShadowBuilds(); ///< tracings of the light on opaque geometry
  int GetShaderBuilds();
  int GetToleranceSearches();
  ///@}

  /**
   * INTERNAL: called by the volume. Draws it, premultiplied, over the renderer's current
   * framebuffer.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  using vtkVolumeMapper::GetBounds;
  /**
   * The bounds of the input; null if they are not finite, so that VTK does not leave the volume out
   * without a word.
   */
  double* GetBounds() override;

protected:
  vtkVariationFieldVolumeMapper();
  ~vtkVariationFieldVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

  /**
   * Draws one volume when its turn among the renderer's volumes has come. Exceptions are reported
   * as errors. A subclass may draw the volume in parts.
   */
  virtual void DrawFrame(vtkRenderer* renderer, vtkVolume* volume);

  int AccelerationMode = OpticalField;
  vtkTypeBool ProcessorMarching = 1;
  int IntegrationRule = Automatic;
  double ErrorTolerance = 1.0 / 64.0;
  double VariationTolerance = -1.0;
  double SampleDistance = 1.0;
  double SampleDistanceInVoxels = 0.0;
  int MaximumNumberOfSteps = 0;
  double FirstDistance = 0.0;
  vtkTypeBool AutoAdjustSampleDistances = 1;
  vtkTypeBool LockSampleDistanceToInputSpacing = 0;
  double EarlyTerminationTransmittance = 1.0 / 1024.0;
  int CompositingOrder = FrontToBack;
  vtkTypeBool CubicInterpolation = 0;
  vtkTypeBool StoredGradients = 0;
  vtkTypeBool UseJittering = 0;
  float ImageSampleDistance = 1.0f;
  int MaximumAccumulatedPictures = 1;
  double LongestPartSeconds = 0.0;
  float MinimumImageSampleDistance = 1.0f;
  float MaximumImageSampleDistance = 10.0f;
  double NanColor[3] = { 0.5, 0.0, 0.0 };
  double NanOpacity = 0.0;
  vtkSmartPointer<vtkImageData> MaskInput;
  int MaskType = LabelMapMaskType;
  float MaskBlendFactor = 1.0f;
  vtkTypeBool LabelSurfaces = 0;
  char* Transfer2DYAxisArray = nullptr;
  double DampingGradient = 0.0;
  vtkTypeBool Shadows = 0;
  double ShadowStrength = 1.0;
  double VolumetricScatteringBlending = 0.0;
  double GlobalIlluminationReach = 0.0;
  double ScatteringAnisotropy = 0.0;
  double AmbientOcclusion = 0.0;
  double AmbientOcclusionReach = 0.0;
  bool DrawFetchCounts = false;
  vtkIdType MaximumGraphicsMemory = 0;
  vtkIdType MaximumHostMemory = 0;
  int LevelOfDetail = AutomaticLevel;
  vtkTypeBool RenderToImage = 0;
  int DepthImageScalarType = VTK_FLOAT;
  vtkTypeBool ClampDepthToBackface = 0;
  float FinalColorWindow = 1.0f;
  float FinalColorLevel = 0.5f;

private:
  void LockSampleDistance();
  void ReportOnce(const std::string& problem);
  void WarnOnce(const std::string& warning, std::string& reported);

  friend class varimarch::SharedSearch;
  struct Internals;
  std::unique_ptr<Internals> Private;

  vtkVariationFieldVolumeMapper(const vtkVariationFieldVolumeMapper&) = delete;
  void operator=(const vtkVariationFieldVolumeMapper&) = delete;
};

#endif
