#ifndef Varimarch_March_RayMarcher_h
#define Varimarch_March_RayMarcher_h

#include "Core/Geometry/PixelRays.h"
#include "Frame/Frame.h"
#include "March/Device/BoxGeometry.h"
#include "March/Device/RayMarchProgram.h"
#include "March/Processor/PacketPicture.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "March/ToleranceSearch.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/PictureResources.h"
#include "Resources/RayAccumulation.h"
#include "Resources/SceneDepthTexture.h"
#include "Resources/VolumeResources.h"

#include "vtkWeakPointer.h"

#include <memory>
#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A box so much larger that it covers all pixels of which the box covers a part, if it is at least
/// a few pixels wide.
Box WithItsEdges(const Box& box);

/// The volume or a block of it, as it is drawn.
struct DrawnBlock
{
  const VolumeBlock* block; ///< null where rays are not marched
  VoxelRegion voxels;
  Box boxGrid;                ///< box that its rays are marched through
  Box coverGrid;              ///< covers the pixels of the rays
  glm::dvec3 sharedUpperGrid; ///< upper faces at which another block begins; elsewhere far away
};

/// The transform from the grid of one volume to that of another.
glm::dmat4 GridFromGrid(const Frame& to, const Frame& from);

/// Draws frames: of a volume or of several that overlap, whole or in blocks, with a ray in each
/// pixel or with fewer or more of them, by shaders or by the processor. Holds what pictures take on
/// the graphics device; what a frame does not need is not there.
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

  const VolumeBuilds& Builds() const { return this->volume.Builds(); }
  int ShaderBuilds() const { return this->shaderBuilds; }
  /// Of all resources, but not those searches for a tolerance, which new views take.
  int ResourceBuilds() const { return this->Builds().Sum() + this->shaderBuilds; }
  int ToleranceSearches() const { return this->tolerance.Searches(); }
  int BlockUploads() const { return this->volume.Blocks().Uploads(); }
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
  const std::optional<ToleranceChoice>& Tolerance() const { return this->tolerance.Choice(); }
  double FieldBuildSeconds() const { return this->volume.FieldBuildSeconds(); }
  std::size_t GraphicsMemoryBytes() const;

private:
  void EnterWindow(vtkOpenGLRenderWindow* window);
  void UpdateDepth(const Frame& frame);
  void UpdateNoise(const Frame& frame);
  void UpdateProgram(const Frame& frame);
  MemoryElsewhere BytesElsewhere() const;

  void KeepTolerance(Frame& frame);
  ToleranceInputs ToleranceInputsOf(const Frame& frame) const;
  std::vector<float> DrawProbe(const Frame& frame);

  // In one piece or in blocks.
  DrawnBlock BoxOfVisible() const;
  DrawnBlock WholeVolume(const Frame& frame);
  bool IsNothingDrawn() const;
  void DrawVolume(const Frame& frame);
  void DrawBlock(Frame frame, int block);
  void DrawBlocks(const Frame& frame);

  // By the processor.
  bool MarchesPackets(const Frame& frame);
  PacketSurroundings SurroundingsOf(const Frame& frame);
  std::vector<float> DrawLayerDepths(const Frame& frame);
  void DrawPackets(const Frame& frame);
  std::vector<float> MarchProbe(const Frame& frame);

  // Several volumes that overlap.
  void UpdateVoxelsOfOthers(const Frame& frame);
  void UpdateOthers(Frame& frame);
  Box BoxOfAll(const Frame& frame) const;
  void ReleaseOthers(vtkWindow* window, std::size_t first);
  std::size_t BytesOfOthers() const;
  MixedScenes MixScenes(PacketScene& first, const Frame& frame, const Viewport& pixels) const;

  // In pictures that others are made of, or that are not seen.
  void BeginAccumulation(Frame& frame);
  void DrawAccumulated(const Frame& frame);
  void DrawBeneath(const Frame& frame);
  void DrawResampled(const Frame& frame);
  void DrawPicture(const Frame& frame);
  void DrawPass(const Frame& frame);
  void DrawImages(const Frame& frame, const Viewport& rays);

  RayParameters ParametersOfRays(const Frame& frame, const DrawnBlock& drawn) const;
  RayTextures TexturesOfRays(const Frame& frame) const;
  void SetVolumes(const Frame& frame, const DrawnBlock& drawn);
  void SetParameters(const Frame& frame, const DrawnBlock& drawn);
  void DrawBox(const Frame& frame, const DrawnBlock& drawn);

  vtkWeakPointer<vtkOpenGLRenderWindow> window;
  VolumeResources volume;
  std::vector<std::unique_ptr<VolumeResources>> others; ///< of volumes that overlap with this one
  SceneDepthTexture depth;
  VolumeBoxGeometry boxGeometry;
  ToleranceSearch tolerance;
  FloatFramebuffer probe;       ///< of rays that are tried out by shaders
  RayAccumulation accumulation; ///< only where there are several blocks
  PictureResources picture;
  PacketPicture packets;
  RayMarchProgram program;
  int shaderBuilds = 0;
  std::vector<std::string> shaderParts;
  Box drawnBox = {}; ///< where rays are marched: through all volumes
  double usedSampleDistanceMm = 0.0;
  double usedImageSampleDistance = 1.0;
};

}

#endif
