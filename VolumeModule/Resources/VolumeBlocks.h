#ifndef Varimarch_Resources_VolumeBlocks_h
#define Varimarch_Resources_VolumeBlocks_h

#include "Core/Blocks/BlockPartition.h"
#include "Core/Blocks/BlockResidency.h"
#include "Resources/FieldTexture.h"
#include "Resources/GapTextures.h"
#include "Resources/VolumeTexture.h"

#include <memory>
#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The textures of one block: its voxels, and what is known of its cells.
struct VolumeBlock
{
  VolumeTexture volume;
  AccelerationField gaps; ///< what is left out; empty where nothing is
  AccelerationField scalarField;
  bool isCurrent = false; ///< whether it holds the scalars as they are now
  bool gapsAreCurrent = false;
  std::optional<double> scalarTolerance; ///< that the field was built for

  bool HasGaps() const { return this->gaps.Bytes() > 0; }
  std::size_t Bytes() const
  {
    return this->volume.Bytes() + this->gaps.Bytes() + this->scalarField.Bytes();
  }
  std::vector<vtkTextureObject*> Textures() const
  {
    return { this->volume.Texture(), this->gaps.Texture(), this->scalarField.Texture() };
  }
  void Release(vtkWindow* window);
};

/// A volume on the graphics device, in one block or in several that come and go: each is uploaded
/// when it is asked for, and stays as long as the memory allows. The voxels stay the caller's.
class VolumeBlocks
{
public:
  /// All blocks will be uploaded anew, into the textures that are there.
  void SetVoxels(const VoxelValues& newValues);

  /// What is left out beside voxels that are not finite; flags that have changed count as scalars.
  void SetBlanking(const Blanking& newBlanking);
  bool MayHaveGaps() const { return !this->Texels().finite || this->blanking.Any(); }

  /// The published field is of cells, and so a matter of blocks. None: no block has it.
  void SetScalarField(vtkWindow* window, std::optional<double> tolerance);

  /// What a voxel takes at most, with what is known of its cells.
  std::size_t BytesPerVoxel() const;

  /// True when the volume is now divided differently: then no block is resident.
  /// @throws std::runtime_error when the limits are too narrow for any block
  bool Divide(vtkWindow* window, const BlockLimits& limits);

  const BlockPartition& Partition() const { return this->partition; }
  const VoxelValues& Values() const { return this->values; }
  const ScalarTexels& Texels() const
  {
    return this->values.texels.front();
  } ///< of the first channel
  const std::vector<ScalarTexels>& TexelsOfChannels() const { return this->values.texels; }

  /// @param order     the blocks that the next picture takes, in this order
  /// @param capacity  no more bytes than that are held from now on
  void BeginPicture(vtkWindow* window, const std::vector<int>& order, std::size_t capacity);

  /// The next block of the order, uploaded if it is not there.
  /// @throws std::runtime_error when the device cannot hold it
  const VolumeBlock& Take(vtkOpenGLRenderWindow* window, int block);

  std::size_t Bytes() const;
  int Uploads() const { return this->uploads; }
  double FieldBuildSeconds() const
  {
    return this->fieldBuildSeconds;
  } ///< of the blocks' fields so far
  void Release(vtkWindow* window);

private:
  void LetGo(vtkWindow* window, const std::vector<int>& released);
  void Upload(vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);
  void UpdateGaps(vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);
  void UpdateScalarField(
    vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);

  VoxelValues values;
  Blanking blanking;
  std::optional<double> scalarTolerance;
  BlockPartition partition;
  BlockResidency residency;
  std::size_t capacity = 0;
  std::vector<std::unique_ptr<VolumeBlock>> blocks; ///< by their number; none: not resident
  int uploads = 0;
  double fieldBuildSeconds = 0.0;
};

}

#endif
