#ifndef Varimarch_RayMarcher_h
#define Varimarch_RayMarcher_h

#include "AccelerationField.h"
#include "BoxInView.h"
#include "Core/FieldDirections.h"
#include "Core/Packets/PacketScene.h"
#include "Core/PixelRays.h"
#include "Core/StepSearch.h"
#include "FloatBufferTexture.h"
#include "FloatTable.h"
#include "Frame.h"
#include "Lights.h"
#include "MaterialTables.h"
#include "OpticalTableTexture.h"
#include "PacketPicture.h"
#include "PictureResources.h"
#include "PreIntegratedTableTexture.h"
#include "ProbeFramebuffer.h"
#include "RayAccumulation.h"
#include "RayMarchProgram.h"
#include "SceneDepthTexture.h"
#include "SplineVolume.h"
#include "VolumeBlocks.h"
#include "VolumeBoxGeometry.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;

namespace varimarch
{

/// How often each resource was made.
struct BuildCounts
{
  int volumeTexture = 0; ///< by new scalars
  int brickRanges = 0;
  int field = 0;
  int opticalTable = 0;
  int shader = 0;
  int tolerance = 0; ///< searches for the steps that keep a tolerance

  /// All but those searches, which new views take.
  int OfResources() const
  {
    return this->volumeTexture + this->brickRanges + this->field + this->opticalTable +
      this->shader;
  }
};

/// What a field was made from; it must be made again when any of it differs.
struct FieldSource
{
  Acceleration acceleration;
  int volumeBuild; ///< of the volume's textures
  int tableBuild;  ///< of the optical table; 0 for a field that does not know it
  double tolerance;
  double sense = 0.0; ///< of extremes: 1 for the largest, -1 for the smallest
  Marcher marcher = Marcher::Device;
  std::vector<double> isovalues = {};
  glm::ivec3 towards = glm::ivec3(0); ///< see FieldDirections

  bool operator==(const FieldSource& other) const
  {
    return this->ShowsSame(other) && this->towards == other.towards;
  }

  /// Whether the same is invisible, whatever the rays.
  bool ShowsSame(const FieldSource& other) const
  {
    return this->isovalues == other.isovalues && this->acceleration == other.acceleration &&
      this->volumeBuild == other.volumeBuild && this->tableBuild == other.tableBuild &&
      this->tolerance == other.tolerance && this->sense == other.sense &&
      this->marcher == other.marcher;
  }
};

/// All that the steps which keep a tolerance depend on.
struct ToleranceInputs
{
  std::vector<double> rule;      ///< that the rule of integration depends on too
  std::vector<double> scene;     ///< in any view
  std::vector<CornersClip> view; ///< where the volumes are in it

  bool operator==(const ToleranceInputs& other) const
  {
    return this->rule == other.rule && this->scene == other.scene && this->view == other.view;
  }
  /// Whether the scene is the same, and the view nearly.
  bool IsNear(const ToleranceInputs& other) const;
};

/// How a picture keeps an error tolerance.
struct ToleranceChoice
{
  ToleranceInputs inputs; ///< that it was found for
  Integration integration;
  StepChoice step;
  double missedOfLimit = 0.0; ///< found once per rule: peaks between samples, as step.ofLimit
};

/// What the numbers of a field of extremes stand for.
struct ExtremeSteps
{
  double sense; ///< 1 for the largest, -1 for the smallest
  double firstValue;
  double valuePerStep;
};

/// The volume or a block of it, as it is drawn.
struct DrawnBlock
{
  const VolumeBlock* block; ///< none where rays are not marched
  VoxelRegion voxels;
  Box boxGrid;                ///< what its rays are marched through
  Box coverGrid;              ///< covers their pixels
  glm::dvec3 sharedUpperGrid; ///< upper faces at which another block begins; elsewhere far away
};

/// What a frame's PacketScene points to, besides what the marcher keeps.
struct PacketArrays
{
  std::vector<glm::vec4> planesGrid;
  std::vector<float> depth; ///< none: there is no geometry
  LightTexels lights;
  std::vector<glm::vec4> isosurfaces;
};

/// A box so much larger that it covers all pixels of which the box covers a part, if it is at least
/// a few pixels wide.
Box WithItsEdges(const Box& box);

/// More segments than any ray has.
int MostSegmentsOf(const Frame& frame);

/// Of each isosurface its colour and optical depth, and its isovalue.
std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame);

/// How packets of rays read these voxels; nothing where they cannot.
std::optional<VoxelType> PacketVoxelTypeOf(const VoxelChannels& channels);

/// Coefficients of ambient, diffuse and specular light, and the specular power.
glm::dvec4 ReflectanceOf(vtkVolumeProperty* property, int component);

/// Draws frames. Holds the graphics resources and remakes those, and only those, whose source has
/// changed since the last frame; what a frame does not need is not there.
class RayMarcher
{
public:
  /// @throws std::runtime_error when the device cannot hold a resource or compile the shader
  void Draw(Frame frame);

  /// The images that were drawn last, as RGBA, or 1 - depth as red; in the window that has them.
  const Viewport& ImagePixels() const { return this->picture.imagePixels; }
  std::vector<float> ColorImage();
  std::vector<float> DepthImage();

  void Release(vtkWindow* window);

  const BuildCounts& Builds() const { return this->builds; }
  int BlockUploads() const { return this->blocks.Uploads(); }
  /// Of the march.
  const std::vector<std::string>& ShaderParts() const { return this->shaderParts; }
  /// How many pictures the last one is the mean of; 0 while the first is not all there.
  int AccumulatedPictures() const;
  /// Of all that is drawn of a scene that stays as it is, [0, 1].
  double DrawnPart(int mostAccumulated) const;
  double UsedImageSampleDistance() const { return this->usedImageSampleDistance; }
  double UsedSampleDistanceMm() const { return this->usedSampleDistanceMm; }
  /// How the last picture keeps its tolerance, or one before from nearly the same place; nothing
  /// when it has none.
  const std::optional<ToleranceChoice>& Tolerance() const { return this->tolerance; }
  double FieldBuildSeconds() const;
  std::size_t GraphicsMemoryBytes() const;

private:
  void EnterWindow(vtkOpenGLRenderWindow* window);
  void UpdateResources(Frame& frame);
  void UpdateVolume(const Frame& frame);
  void UpdateOpticalTable(const Frame& frame);
  void UpdatePreIntegratedTable(const Frame& frame);
  void UpdateField(const Frame& frame);
  void UpdateScalarField(const Frame& frame);
  void UpdateOpticalField(const Frame& frame);
  void UpdateExtremes(const Frame& frame);
  void UpdateIsosurfaceField(const Frame& frame);
  bool BeginsField(const Frame& frame, FieldSource& source);
  void UpdateIsosurfaces(const Frame& frame);
  void UpdateSpacing(const Frame& frame);
  void SetSpacingUniforms(const Frame& frame);
  void UpdateRanges();
  void UpdateDepth(const Frame& frame);
  void UpdateLights(const Frame& frame);
  void UpdateGradientOpacity(const Frame& frame);
  void UpdateMask(const Frame& frame);
  std::vector<OpticalTable> BuildTables(const Frame& frame);
  void UpdateNoise(const Frame& frame);
  void UpdateCuts(const Frame& frame);
  void UpdateBlocks(Frame& frame);
  void UpdateTolerance(const Frame& frame);
  void UpdateProgram(const Frame& frame);

  double SampleDistanceInView() const;
  ToleranceChoice ChooseSteps(const Frame& frame, const ToleranceInputs& inputs);
  double MissedOfLimit(const Frame& frame, const ToleranceChoice& choice, const ErrorLimit& limit);
  /// Whether another rule may keep the limit in less time than midpoints.
  bool PreIntegrationMayPay(
    const Frame& frame, const ToleranceChoice& choice, const ErrorLimit& limit);
  std::vector<float> DrawProbe(Frame frame, Integration integration, double sampleDistanceMm);

  // The volume in blocks.
  BlockLimits LimitsOf(const Frame& frame) const;
  std::size_t FixedBytes(const Frame& frame) const;
  std::size_t BytesForBlocks(const Frame& frame) const;
  void UpdateVisibleBoxes(const Frame& frame);
  std::vector<int> BlocksInView(const Frame& frame) const;
  DrawnBlock BoxOfVisible() const;
  void DrawVolume(const Frame& frame);
  void DrawBlock(Frame frame, int block);
  void DrawBlocks(const Frame& frame);

  // By the processor.
  bool MarchesPackets(const Frame& frame);
  bool HasPlainValues(const Frame& frame);
  VoxelChannels ChannelsReadBy(const Frame& frame) const; ///< of packets
  PacketTwoValues TwoValuesOfPackets(const Frame& frame) const;
  PacketLook LookOfPackets(const Frame& frame) const;
  PacketSteps StepsOfPackets(const Frame& frame) const;
  PacketGradientOpacity GradientOpacityOfPackets(const Frame& frame) const;
  PacketExtreme ExtremeOfPackets(const Frame& frame) const;
  PacketProjection ProjectionOfPackets(const Frame& frame) const;
  PacketScene SceneOfPackets(const Frame& frame, const PacketArrays& arrays) const;
  void DrawPackets(const Frame& frame);
  void SetMarchedUniforms(const Frame& frame, const glm::dmat4& clipFromGrid);

  // Several volumes that overlap: the first is this marcher's, and draws all.
  void UpdateOthers(Frame& frame);
  void CheckOneBlock(const Frame& frame) const;
  Box BoxOfAll(const Frame& frame) const;
  void ReleaseOthers(vtkWindow* window, std::size_t first);
  std::size_t BytesOfOthers() const;
  void AddToleranceInputs(const Frame& frame, ToleranceInputs& inputs) const;
  DrawnBlock WholeVolume(const Frame& frame);
  std::vector<vtkTextureObject*> TexturesOf(const DrawnBlock& drawn) const;
  void SetPlaceUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetOwnUniforms(const Frame& frame, const glm::dmat4& gridFromRays);
  void SetUniformsOfOthers(const Frame& frame);

  void BeginAccumulation(Frame& frame);
  void DrawAccumulated(const Frame& frame);
  void DrawBeneath(const Frame& frame);
  void DrawResampled(const Frame& frame);
  void DrawPicture(const Frame& frame);
  void DrawPass(const Frame& frame);
  void DrawImages(const Frame& frame, const Viewport& rays);

  void SetRayUniforms(const Frame& frame, const DrawnBlock& drawn, const glm::dmat4& clipFromGrid);
  void SetResumeUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetResampledUniforms(const Frame& frame);
  void SetMeanUniforms(const Frame& frame, const glm::dmat4& clipFromGrid);
  void SetPassUniforms(const Frame& frame, const glm::dmat4& clipFromGrid);
  void SetNoiseUniforms();
  void SetGapUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetCutUniforms(const Frame& frame);
  void SetDepthUniforms(const Frame& frame, const glm::dmat4& clipFromGrid);
  ExtremeSteps ExtremeStepsOf(Blend blend) const;
  void SetStepUniforms(const Frame& frame, const VolumeBlock& block);
  void SetClassifyUniforms(const Frame& frame);
  void SetComponentTableUniforms();
  void SetComponentUniforms(const Frame& frame);
  void SetComponentProjectionUniforms(const Frame& frame);
  void SetPreIntegratedUniforms();
  void SetExactUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetMaterialUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetLightUniforms(const Frame& frame);
  void SetMaskUniforms(const Frame& frame);
  void SetTwoValueUniforms(const Frame& frame);
  void SetGradientOpacityUniforms(const Frame& frame);
  void SetBlendUniforms(const Frame& frame);
  void SetProjectionUniforms(const Frame& frame);
  void SetMarchUniforms(const Frame& frame, const DrawnBlock& drawn);
  void SetUniforms(const Frame& frame, const DrawnBlock& drawn);
  void DrawBox(const Frame& frame, const DrawnBlock& drawn);

  vtkWeakPointer<vtkOpenGLRenderWindow> window;
  SplineVolume spline; ///< only where voxels are interpolated by one
  VolumeBlocks blocks;
  AccelerationField field; ///< of bricks
  OpticalTableTexture opticalTable;
  PreIntegratedTableTexture preIntegratedTable;
  SceneDepthTexture depth;
  MaskTexture mask;
  FloatTable twoValues; ///< a transfer function of two values
  glm::ivec2 twoValuesSize = glm::ivec2(1);
  FloatTable gradientOpacity;
  FloatBufferTexture lights; ///< only for the device, where there are others than head lights
  FloatBufferTexture clippingPlanes;
  FloatBufferTexture isosurfaces;
  FloatBufferTexture spacing;         ///< only where voxels are at uneven places,
  std::vector<glm::vec4> spacingBins; ///< made of these
  VolumeBoxGeometry boxGeometry;
  ProbeFramebuffer probe;
  RayAccumulation accumulation; ///< only where there are several blocks
  PictureResources picture;
  PacketPicture packets;
  RayMarchProgram program;
  BuildCounts builds;
  std::optional<ToleranceChoice> tolerance;
  std::vector<CornersClip> toleranceView; ///< of the last picture that kept one
  bool viewRests = false;                 ///< that is also the view of the picture before
  double usedSampleDistanceMm = 0.0;
  double usedImageSampleDistance = 1.0;
  std::vector<std::string> shaderParts;
  std::vector<std::unique_ptr<RayMarcher>> others; ///< of volumes that overlap with this one
  Box drawnBox = {};                               ///< where rays are marched: through all volumes
  Box visibleBox = {};                             ///< what of the volume is drawn
  std::vector<Box> visibleBoxes;                   ///< and of each block

  // What each resource was made from.
  VoxelChannels volumeSource; ///< none: there is no volume
  vtkMTimeType volumeTime = 0;
  bool volumeIsCubic = false;
  vtkVolumeProperty* tableSource = nullptr;
  std::vector<double> tableInputs;
  std::vector<MaterialTable> materialTables; ///< what is in the optical table
  std::vector<double> gradientOpacitySource; ///< empty: there is none
  int preIntegratedOfTable = 0;              ///< the optical table's build that it was made from
  std::optional<FieldSource> fieldSource;    ///< none: there is no field
  FieldDirections fieldDirections;
  std::optional<bool> voxelsAreFinite; ///< none: nobody has asked
  int rangesOfVolume = 0;              ///< the volume's build that the field's ranges belong to
  int visibleOfField = -1; ///< the field's build that the visible boxes belong to; 0: to none
  Box visibleOfBox = {};   ///< and the box that cuts left then
};

}

#endif
