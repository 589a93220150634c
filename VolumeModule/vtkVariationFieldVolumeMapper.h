/**
 * @class   vtkVariationFieldVolumeMapper
 * @brief   Draws a volume by ray marching that jumps where the volume hardly varies
 *
 * A direct vtkVolumeMapper for vtkImageData with one to four components of point data, of any
 * scalar type. It marches a ray per pixel through the volume in a fragment shader. Where the
 * *variation field* proves that the volume stays within a tolerance, the ray takes the whole block
 * in one step and integrates emission and absorption over it in closed form, instead of sampling
 * it.
 *
 * Use it like any other volume mapper:
 * @code
 *   vtkNew<vtkVariationFieldVolumeMapper> mapper;
 *   mapper->SetInputConnection(reader->GetOutputPort());
 *   volume->SetMapper(mapper);
 * @endcode
 *
 * World lengths are taken to be mm, as in medical data; any other unit works as long as
 * vtkVolumeProperty::SetScalarOpacityUnitDistance uses it too. Lengths are measured in world
 * space, so a volume scaled by its matrix becomes thicker, as a scaled object should.
 *
 * Blend modes: composite, maximum, minimum and average intensity, additive, as VTK has them, in the
 * limit that its samples tend to.
 *
 * Voxels that are not finite (NaN, infinity) have no value: the cells that touch one are left out,
 * transparent unless NanOpacity asks for a colour, and without a maximum; beside them there is only
 * ambient light. Other volumes pay nothing for that.
 *
 * Shading is by all lights that are on, from where they are, and on both sides of surfaces or on
 * one, as the renderer says; a surface faces to where the values fall. Ambient light is that of the
 * lights, as in VTK, but where there are head lights only it is white.
 *
 * A vtkHardwareSelector selects the volume, and the point or cell at which a ray becomes half
 * opaque or, where it never does, visible. Translucent geometry in the volume is right with
 * vtkRenderer::SetUseDepthPeeling and SetUseDepthPeelingForVolumes.
 *
 * Code of one's own takes the place of a slot of the shader, a folder of VolumeModule/Shaders whose
 * contract is in Slots.glsl there, by the volume's vtkShaderProperty:
 * @code
 *   volume->GetShaderProperty()->AddFragmentShaderReplacement("//Varimarch::Window", true,
 *     "vec4 Windowed(vec4 picture) { return picture.bgra; }", false);
 * @endcode
 * Its fragment custom uniforms are declared for it, and vtkCommand::UpdateShaderEvent is sent by
 * the volume's mapper before each drawing. Fields do not know the code: AccelerationModeOff if it
 * shows what the transfer function does not.
 *
 * The camera's clipping range cuts the volume at both ends.
 *
 * Independent components are materials of a mixture: their extinctions and emissions, each times
 * its weight, add up, in whatever order they are. A maximum or minimum adds, up to 1, colour and
 * opacity of what each is over its unit distance; averages and sums are weighted. Of two components
 * that depend on each other the first has the colour and the second the opacity; of four, the first
 * three are a colour, in parts of 255, of the largest number of 16 bit types, or of 1 for floats.
 * Their light is that on the first component.
 *
 * Interpolation is what the property says, by default nearest as everywhere in VTK: voxels are then
 * boxes of one value, and drawn exactly. So are isosurfaces, and slices by a function of second
 * degree, such as a vtkPlane or vtkSphere; steps and error tolerance have no say in these.
 * CubicInterpolation draws a spline through the voxels where the property says linear.
 *
 * A rectilinear grid is interpolated between its own coordinates; the scalar field is not for it.
 *
 * Several inputs are the volumes of a vtkMultiVolume, which may overlap: a composite of the sum of
 * their extinctions and emissions, each with its own matrix, property and kind of voxels. As
 * vtkMultiVolume asks a vtkGPUVolumeRayCastMapper for its bounds, programs set them up with
 * vtkVariationFieldGPUVolumeRayCastMapper. Not with masks, cropping, blanked voxels or voxels that
 * are not finite, cuts as surfaces, user code, images of depth, or in blocks.
 *
 * Of independent components, isosurfaces are those of the one with the largest weight.
 *
 * Not for: isosurfaces of components that depend on each other, or of rectilinear grids. They are
 * reported as errors.
 *
 * @sa vtkVolumeMapper vtkVolumeProperty
 */

#ifndef vtkVariationFieldVolumeMapper_h
#define vtkVariationFieldVolumeMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkSmartPointer.h"       // For MaskInput
#include "vtkVolumeMapper.h"

#include <memory> // For Internals
#include <string> // For ReportOnce

class vtkImageData;
class vtkStringArray;

class VARIMARCHVOLUME_EXPORT vtkVariationFieldVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkVariationFieldVolumeMapper* New();
  vtkTypeMacro(vtkVariationFieldVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum AccelerationModes
  {
    Off,         ///< no field: every step has the sample distance
    ScalarField, ///< the published field, of the scalar, with VariationTolerance
    OpticalField ///< the field of what the transfer function shows
  };

  ///@{
  /**
   * What lets a ray skip samples. Default: OpticalField, which knows the transfer function: it
   * leaves what is invisible at once, and crosses what looks the same in one step, at a cost of at
   * most 1/255 in a channel. For a maximum or minimum it leaves what would not change what is seen
   * of the one found so far; so it is for sums and averages, if all scalars count in these.
   */
  vtkSetClampMacro(AccelerationMode, int, Off, OpticalField);
  vtkGetMacro(AccelerationMode, int);
  void SetAccelerationModeToOff() { this->SetAccelerationMode(Off); }
  void SetAccelerationModeToScalarField() { this->SetAccelerationMode(ScalarField); }
  void SetAccelerationModeToOpticalField() { this->SetAccelerationMode(OpticalField); }
  ///@}

  ///@{
  /**
   * Where OpenGL itself is drawn by the processor, as Mesa's llvmpipe does, march rays without a
   * shader, in packets of eight: two to ten times as fast, by the same rules, but of several
   * components, volumes that overlap and rectilinear grids by midpoints. It needs AVX2 and FMA;
   * shaders draw what packets have no code for (slices, masks of other sizes than the volume's,
   * functions of two arrays, light on volumes with values that are not finite, user code, a maximum
   * graphics memory; isosurfaces, averages and sums of nearest interpolation; extremes, averages
   * and sums of several components or of rectilinear grids, or drawn to images). Voxels of several
   * components, of other types than 8 and 16 bit integers and float, and floats that are not all
   * finite, are copied for it. Default: on.
   */
  vtkSetMacro(ProcessorMarching, vtkTypeBool);
  vtkGetMacro(ProcessorMarching, vtkTypeBool);
  vtkBooleanMacro(ProcessorMarching, vtkTypeBool);
  ///@}

  ///@{
  /**
   * For ScalarField: largest difference of two values in a block that a ray may jump across, in
   * units of the data.
   * A negative value (the default) means 1/256 of the range of the scalars.
   */
  vtkSetMacro(VariationTolerance, double);
  vtkGetMacro(VariationTolerance, double);
  ///@}

  enum IntegrationRules
  {
    Automatic,     ///< Midpoint, or PreIntegrated where it keeps the error tolerance in less time;
                   ///< PreIntegrated of materials (see below) without a tolerance
    Midpoint,      ///< homogeneous, as in the middle of a step
    PreIntegrated, ///< linear between samples, the transfer function exact
    Simpson,       ///< parabolas of extinction through three samples
    PublishedSum   ///< the published sum of repeated samples, to show its error
  };

  ///@{
  /**
   * How a composite is integrated between samples. Of what depends on gradients or on several
   * values, such as light, there are midpoints only and what is linear between samples, in four
   * parts, which all but Midpoint then mean. Default Automatic.
   */
  vtkSetClampMacro(IntegrationRule, int, Automatic, PublishedSum);
  vtkGetMacro(IntegrationRule, int);
  ///@}

  ///@{
  /**
   * Largest error accepted in a premultiplied RGBA channel of a pixel before the background, 0 to
   * 1, default 1/64. While it is above 0 and AutoAdjustSampleDistances is on, the mapper chooses
   * sample distance, integration rule, field tolerance and early termination so that 99.9 % of the
   * pixels keep it and none exceeds twice as much. A new view is first tried out with a few
   * thousand of its rays, which costs a tenth to a fifth of a picture's time and serves the views
   * nearby while a camera moves; what they miss is not known, so this is an estimate, not a proof:
   * of rays that just graze a hard surface, and of a peak of opacity too thin for any sample, it
   * knows nothing. What cannot be kept with 128 samples per voxel is reported as a warning. 0:
   * sample distance and early termination are what their own settings say.
   */
  vtkSetClampMacro(ErrorTolerance, double, 0.0, 1.0);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  /**
   * What the error of the steps was estimated to be, in the last picture or in one of a view
   * nearby: 99.9 % of the pixels are off by no more, in units of 1. 0 without an error tolerance.
   */
  double GetEstimatedError();

  ///@{
  /**
   * How a composite shows the cells that touch a voxel that is not finite, be it NaN or an
   * infinity: a material of this colour, not lit, and of this opacity over one
   * vtkVolumeProperty::ScalarOpacityUnitDistance, each [0, 1]. Named as in vtkLookupTable; the
   * NaN colours of the property's functions are not used, for those are opaque by default. Default:
   * opacity 0, transparent; colour (0.5, 0, 0). The other blend modes leave these cells out.
   */
  vtkSetVector3Macro(NanColor, double);
  vtkGetVector3Macro(NanColor, double);
  vtkSetClampMacro(NanOpacity, double, 0.0, 1.0);
  vtkGetMacro(NanOpacity, double);
  ///@}

  ///@{
  /**
   * Draw, in place of the picture, how often each ray has read the volume: as red, not scaled, so
   * only into a framebuffer of floats. For measurements. Default off.
   */
  vtkSetMacro(DrawFetchCounts, bool);
  vtkBooleanMacro(DrawFetchCounts, bool);
  vtkGetMacro(DrawFetchCounts, bool);
  ///@}

  ///@{
  /**
   * Distance between samples along a ray [world units, mm], > 0. Default 1. Used only while
   * AutoAdjustSampleDistances is off. At most 20000 samples are taken along the diagonal of the
   * volume by shaders, 10000 where it is lit, and 80000 by the processor; a shorter distance is
   * lengthened to that, with a warning.
   */
  vtkSetClampMacro(SampleDistance, double, 1e-30, 1e30);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * While on, SampleDistance is set with every picture to what VTK derives from the spacing of the
   * input: half the mean spacing, less for few voxels (vtkVolumeMapper). Default off. Like
   * SampleDistance it has an effect only while AutoAdjustSampleDistances is off.
   */
  vtkSetClampMacro(LockSampleDistanceToInputSpacing, vtkTypeBool, 0, 1);
  vtkGetMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
  vtkBooleanMacro(LockSampleDistanceToInputSpacing, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the mapper chooses the sample distance: by the error tolerance, or, where that is 0, a
   * part of the smallest spacing of the voxels in the world. Default on.
   */
  vtkSetClampMacro(AutoAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(AutoAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(AutoAdjustSampleDistances, vtkTypeBool);
  ///@}

  ///@{
  /**
   * A ray ends when less than this part of the light behind it would reach the eye. The largest
   * error it makes in a pixel's premultiplied channel. Range [0, 1), default 1/1024. An error
   * tolerance in use chooses it.
   */
  vtkSetClampMacro(EarlyTerminationTransmittance, double, 0.0, 0.999999);
  vtkGetMacro(EarlyTerminationTransmittance, double);
  ///@}

  ///@{
  /**
   * Where the gradient is smaller than this, in units of the data per mean spacing of the voxels as
   * for gradient opacity, diffuse and specular light are damped in proportion: a homogeneous
   * material, whose gradient is noise, keeps its ambient light only, and surfaces stand out of it.
   * After Volt (2009). Of volumes of one component. 0, the default: light as it is.
   */
  vtkSetClampMacro(DampingGradient, double, 0.0, 1e30);
  vtkGetMacro(DampingGradient, double);
  ///@}

  ///@{
  /**
   * Whether voxels that the property asks to interpolate linearly are interpolated by a tricubic
   * spline through them: every voxel keeps its value, and edges have no staircase; but beside a
   * sharp one the values go beyond those of the voxels, by up to a tenth of the step. Lights see
   * the gradient of the spline. A sample costs eight readings, and voxels take four bytes of
   * graphics memory and as much of the program's. Not of rectilinear grids, of isosurfaces, and of
   * voxels that are not finite. Default off.
   */
  vtkSetClampMacro(CubicInterpolation, vtkTypeBool, 0, 1);
  vtkGetMacro(CubicInterpolation, vtkTypeBool);
  vtkBooleanMacro(CubicInterpolation, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the first sample of each ray is moved by a noise (blue: neighbours share none of it),
   * the same in every picture. It turns the rings that a sample distance too long for the data
   * makes into a fine grain. Default off.
   */
  vtkSetClampMacro(UseJittering, vtkTypeBool, 0, 1);
  vtkGetMacro(UseJittering, vtkTypeBool);
  vtkBooleanMacro(UseJittering, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Distance of rays in the picture [pixels], 0.1 to 100, default 1: a ray for each pixel. With a
   * longer one the pixels between are interpolated, not across edges of opaque geometry; with a
   * shorter one, rounded to 1/2, 1/3 and so on, each pixel is the mean of its rays.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Between these the mapper chooses the image sample distance while somebody interacts: while
   * AutoAdjustSampleDistances is on and the volume has been allocated less than a second, as it is
   * where the window's desired update rate is above 1. Pictures are then drawn with fewer rays and
   * up to four times the error tolerance, as the time that the last ones took asks for; and in full
   * as soon as nobody does. Defaults 1 and 10.
   */
  vtkSetClampMacro(MinimumImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 0.1f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * While the scene stays as it is, each picture that is asked for is drawn with its rays elsewhere
   * in their pixels, and from the second one with a quarter of the error tolerance, and the mean of
   * all is shown: edges become smooth, at the cost of one picture each. Not more than so many are
   * drawn; a program that has time renders until GetAccumulatedPictures says so. Anything that
   * changes what is seen begins anew; while somebody interacts, and with an ImageSampleDistance
   * other than 1, each picture stands alone, and where UpdateShaderEvent is observed too. Default
   * 1: off.
   */
  vtkSetClampMacro(MaximumAccumulatedPictures, int, 1, 65536);
  vtkGetMacro(MaximumAccumulatedPictures, int);
  /// How many the last picture is the mean of; 1 when off, 0 while the first is not all there.
  int GetAccumulatedPictures();
  ///@}

  ///@{
  /**
   * How long a Render() is to draw a picture of a scene that stays as it is [s]. What is not drawn
   * by then is shown coarsely, and the next Render() goes on, so that a program stays responsive
   * while large pictures come; it renders until GetDrawnPart() is 1. As for accumulated pictures,
   * anything that changes what is seen begins anew, and where those stand alone, and for a volume
   * in blocks, pictures are drawn at once. Default 0: always.
   */
  vtkSetClampMacro(LongestPartSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestPartSeconds, double);
  double GetDrawnPart(); ///< of all pictures that are to be accumulated, [0, 1]
  ///@}

  /**
   * The image sample distance of the last picture [pixels].
   */
  double GetUsedImageSampleDistance();

  ///@{
  /**
   * Draw into images and not into the window: the picture, RGBA of unsigned char, over white that
   * is clear; and the depth, as in a depth buffer, at which anything first is visible, 1 where
   * nothing is or, with ClampDepthToBackface, where the ray leaves the volume. Both are those of
   * the last picture, as large as the renderer over the image sample distance. Default off; float.
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
   * Colours of the picture from FinalColorLevel - FinalColorWindow / 2 to FinalColorLevel +
   * FinalColorWindow / 2 are shown as black to white, before they are multiplied by opacity. A
   * negative window reverses them. Defaults 1 and 0.5: colours as they are.
   */
  vtkSetMacro(FinalColorWindow, float);
  vtkGetMacro(FinalColorWindow, float);
  vtkSetMacro(FinalColorLevel, float);
  vtkGetMacro(FinalColorLevel, float);
  ///@}

  enum TypesOfMask
  {
    BinaryMaskType,
    LabelMapMaskType
  };

  ///@{
  /**
   * A mask over the same box as the volume, of any resolution: of one component, each voxel of it
   * filling the cube around it. Default: none. As in vtkGPUVolumeRayCastMapper a binary mask
   * confines all blend modes to where it is above 0; a label map, the default type, makes
   * composites of one component show each voxel by the functions of its label
   * (vtkVolumeProperty::SetLabelColor, SetLabelScalarOpacity, SetLabelGradientOpacity), of any
   * value. What a label has no function for is as without a label.
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
   * How much of a label map's functions is used, the rest being those without a label. Range [0,
   * 1], default 1.
   */
  vtkSetClampMacro(MaskBlendFactor, float, 0.0f, 1.0f);
  vtkGetMacro(MaskBlendFactor, float);
  ///@}

  ///@{
  /**
   * Name of the array of point data that is the second value of a transfer function of two
   * (vtkVolumeProperty::SetTransferFunction2D); none, the default: the magnitude of the gradient.
   * Of the function's image, the first and the last point on each axis are the ends of the values'
   * ranges; gradients are measured as for gradient opacity.
   */
  vtkSetStringMacro(Transfer2DYAxisArray);
  vtkGetStringMacro(Transfer2DYAxisArray);
  ///@}

  /**
   * The sample distance of the last picture [world units].
   */
  double GetUsedSampleDistance();

  /**
   * Time to build the field last time [s]; 0 before. What reads the volume is built, and counts,
   * only with a new volume.
   */
  double GetFieldBuildSeconds();

  ///@{
  /**
   * Most graphics memory that this mapper may take [bytes]; 0, the default: what the device has.
   * A volume that does not fit, or that is larger than the device's 3D textures may be, is drawn in
   * blocks, of which those stay in graphics memory that find room; the others are uploaded when
   * their turn comes. A volume that fits is drawn at once, and pays nothing for this.
   */
  vtkSetClampMacro(MaximumGraphicsMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumGraphicsMemory, vtkIdType);
  ///@}

  /**
   * Bytes of graphics memory this mapper holds now, textures and buffers.
   */
  vtkIdType GetGraphicsMemoryBytes();

  /**
   * Whether the last picture keeps the ErrorTolerance everywhere. Not where single rays graze what
   * is hard; a warning tells how many, and how fine the samples were.
   */
  bool GetErrorToleranceIsKept();

  /**
   * The shader files of the last picture, one per slot, as paths below VolumeModule/Shaders; none
   * where the processor has marched its rays.
   */
  void GetShaderParts(vtkStringArray* parts);

  ///@{
  /**
   * How often each part was built since this mapper was made: what
   * Documentation/Architecture.md promises to be rebuilt, and nothing else.
   */
  int GetVolumeTextureBuilds(); ///< by new scalars
  int GetBlockUploads();        ///< of the volume, or of the blocks that it is drawn in
  int GetBrickRangesBuilds();
  int GetFieldBuilds(); ///< but not of the same field for rays of other directions
  int GetOpticalTableBuilds();
  int GetShaderBuilds();
  int GetToleranceSearches();
  ///@}

  /**
   * INTERNAL: called by the volume. Draws it into the renderer's current framebuffer,
   * premultiplied, over what is there.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkVariationFieldVolumeMapper();
  ~vtkVariationFieldVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

  int AccelerationMode = OpticalField;
  vtkTypeBool ProcessorMarching = 1;
  int IntegrationRule = Automatic;
  double ErrorTolerance = 1.0 / 64.0;
  bool DrawFetchCounts = false;
  double VariationTolerance = -1.0;
  double SampleDistance = 1.0;
  vtkTypeBool AutoAdjustSampleDistances = 1;
  vtkTypeBool LockSampleDistanceToInputSpacing = 0;
  double EarlyTerminationTransmittance = 1.0 / 1024.0;
  double NanColor[3] = { 0.5, 0.0, 0.0 };
  double NanOpacity = 0.0;
  vtkIdType MaximumGraphicsMemory = 0;
  vtkSmartPointer<vtkImageData> MaskInput;
  int MaskType = LabelMapMaskType;
  float MaskBlendFactor = 1.0f;
  char* Transfer2DYAxisArray = nullptr;
  double DampingGradient = 0.0;
  vtkTypeBool CubicInterpolation = 0;
  vtkTypeBool UseJittering = 0;
  float ImageSampleDistance = 1.0f;
  int MaximumAccumulatedPictures = 1;
  double LongestPartSeconds = 0.0;
  float MinimumImageSampleDistance = 1.0f;
  float MaximumImageSampleDistance = 10.0f;
  vtkTypeBool RenderToImage = 0;
  int DepthImageScalarType = VTK_FLOAT;
  vtkTypeBool ClampDepthToBackface = 0;
  float FinalColorWindow = 1.0f;
  float FinalColorLevel = 0.5f;

private:
  void LockSampleDistance();
  void DrawFrame(vtkRenderer* renderer, vtkVolume* volume);
  void ReportOnce(const std::string& problem);
  void WarnOnce(const std::string& warning);

  struct Internals;
  std::unique_ptr<Internals> Private;

  vtkVariationFieldVolumeMapper(const vtkVariationFieldVolumeMapper&) = delete;
  void operator=(const vtkVariationFieldVolumeMapper&) = delete;
};

#endif
