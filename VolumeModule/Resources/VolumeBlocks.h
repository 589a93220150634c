#ifndef Varimarch_Resources_VolumeBlocks_h
#define Varimarch_Resources_VolumeBlocks_h

#include "Core/Blocks/BlockPartition.h"
#include "Core/Blocks/BlockResidency.h"
#include "Resources/FieldTexture.h"
#include "Resources/VolumeGaps.h"
#include "Resources/VolumeTexture.h"

#include <memory>
#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The textures of one block: its voxels, and the fields of its cells.
struct VolumeBlock
{
  VolumeTexture volume;
  AccelerationField gaps; ///< The cells that are left out; empty if there are none.
  AccelerationField scalarField;
  bool isCurrent = false; ///< True if the texture has the present scalars.
  bool gapsAreCurrent = false;
  std::optional<double> scalarTolerance; ///< The tolerance that the field was built for.

  bool HasGaps() const { return this->gaps.Bytes() > 0; }
  std::size_t Bytes() const
  {
    return this->volume.Bytes() + this->gaps.Bytes() + this->scalarField.Bytes();
  }
  void Release(vtkWindow* window);
};

/// A volume on the graphics device, in one block or in several: each is uploaded when it is asked
/// for, and stays as long as the memory allows. The voxels belong to the caller.
class VolumeBlocks
{
public:
  /// Takes other voxels. All blocks will be uploaded again, into the same textures.
  void SetVoxels(const VoxelValues& newValues);

  /// Takes the flags that leave out voxels beside those that are not finite.
  void SetBlanking(const Blanking& newBlanking);
  bool MayHaveGaps() const { return !this->Texels().finite || this->blanking.Any(); }

  /// Sets the tolerance of the scalar field, which each block has for its cells; nothing if no
  /// block is to have one.
  void SetScalarField(vtkWindow* window, std::optional<double> tolerance);

  /// The memory of a voxel at most, with the fields of its cells.
  std::size_t BytesPerVoxel() const;

  /// @return true if the volume is now divided differently: then no block is resident
  /// @throws std::runtime_error if the limits are too narrow for any block
  bool Divide(vtkWindow* window, const BlockLimits& limits);

  const BlockPartition& Partition() const { return this->partition; }
  const VoxelValues& Values() const { return this->values; }
  /// The format of the first component.
  const ScalarTexels& Texels() const { return this->values.texels.front(); }
  const std::vector<ScalarTexels>& TexelsOfComponents() const { return this->values.texels; }

  /// @param order     the blocks that the next image takes, in this order
  /// @param capacity  the bytes that are held at most from now on
  void BeginPicture(vtkWindow* window, const std::vector<int>& order, std::size_t capacity);

  /// The next block of the order, uploaded if it is not resident.
  /// @throws std::runtime_error if the device cannot hold it
  const VolumeBlock& Take(vtkOpenGLRenderWindow* window, int block);

  std::size_t Bytes() const;
  int Uploads() const { return this->uploads; }
  /// The time that the fields of blocks have taken so far.
  double FieldBuildSeconds() const { return this->fieldBuildSeconds; }
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
  std::vector<std::unique_ptr<VolumeBlock>> blocks; ///< By their number; null if not resident.
  int uploads = 0;
  double fieldBuildSeconds = 0.0;
};

}

#endif
