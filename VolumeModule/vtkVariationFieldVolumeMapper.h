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
 * How rays sample the volume is set by the methods of vtkSampledVolumeMapper, light, masks and
 * values that are missing by those of vtkMaterialVolumeMapper.
 *
 * @sa vtkSampledVolumeMapper vtkMaterialVolumeMapper vtkVolumeProperty
 */

#ifndef vtkVariationFieldVolumeMapper_h
#define vtkVariationFieldVolumeMapper_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkMaterialVolumeMapper.h"

#include <memory> // For Internals
#include <string> // For ReportOnce

class vtkImageData;
class vtkStringArray;

namespace varimarch
{
class SharedSearch;
}

class VARIMARCHVOLUME_EXPORT vtkVariationFieldVolumeMapper : public vtkMaterialVolumeMapper
{
public:
  static vtkVariationFieldVolumeMapper* New();
  vtkTypeMacro(vtkVariationFieldVolumeMapper, vtkMaterialVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  using vtkMaterialVolumeMapper::GetBounds;
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
