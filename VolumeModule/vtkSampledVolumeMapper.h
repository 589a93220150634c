/**
 * @class   vtkSampledVolumeMapper
 * @brief   How finely a volume mapper samples rays and images
 *
 * The settings of vtkVariationFieldVolumeMapper for the accuracy and the speed of a ray march:
 * fields and rules, the error tolerance, distances of samples along rays and on the image.
 */

#ifndef vtkSampledVolumeMapper_h
#define vtkSampledVolumeMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkVolumeMapper.h"

class VARIMARCHVOLUME_EXPORT vtkSampledVolumeMapper : public vtkVolumeMapper
{
public:
  vtkTypeMacro(vtkSampledVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

protected:
  vtkSampledVolumeMapper() = default;
  ~vtkSampledVolumeMapper() override = default;

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

private:
  vtkSampledVolumeMapper(const vtkSampledVolumeMapper&) = delete;
  void operator=(const vtkSampledVolumeMapper&) = delete;
};

#endif
