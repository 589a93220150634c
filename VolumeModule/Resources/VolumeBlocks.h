#ifndef Varimarch_Resources_VolumeBlocks_h
#define Varimarch_Resources_VolumeBlocks_h

#include "Core/Blocks/BlockPartition.h"
#include "Resources/FieldTexture.h"
#include "Resources/VolumeGaps.h"
#include "Resources/VolumeTexture.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// The gradients of the first component as a 3D texture: for each voxel the differences between the
/// texels one voxel to either side. Three numbers of 16 bits, normalised if the volume's texels
/// are, otherwise floats.
class GradientTexture
{
public:
  static constexpr std::size_t BytesPerVoxel = 3 * 2;

  /// Computes and uploads the gradients of a region. A texture of the same size and format is
  /// reused.
  /// @param texels  format of the first component
  /// @throws std::runtime_error if the device cannot hold the texture
  void Upload(
    vtkOpenGLRenderWindow* window, const ScalarRegion& region, const ScalarTexels& texels);

  vtkTextureObject* Texture() const { return this->texture; }
  std::size_t Bytes() const { return this->bytes; }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  std::size_t bytes = 0;
};

/// The textures of one block: its voxels and the fields of its voxels and cells.
struct VolumeBlock
{
  VolumeTexture volume;
  AccelerationField gaps;       ///< The cells without values; empty if there are none.
  AccelerationField valueField; ///< A field of the values alone, if the acceleration has one.
  GradientTexture gradients;    ///< Empty unless gradients are stored.
  bool isCurrent = false;       ///< True if the texture is up to date.
  bool gapsAreCurrent = false;
  bool gradientsAreCurrent = false;
  std::optional<ValueField> valueFieldOf; ///< The choice that the field was built for.

  bool HasGaps() const { return this->gaps.Bytes() > 0; }
  std::size_t Bytes() const
  {
    return this->volume.Bytes() + this->gaps.Bytes() + this->valueField.Bytes() +
      this->gradients.Bytes();
  }
  void Release(vtkWindow* window);
};

/// A volume on the graphics device, in one or several blocks. Each block is uploaded when it is
/// taken, and stays resident as long as memory allows. The voxels belong to the caller.
class VolumeBlocks
{
public:
  /// Replaces the voxels. All blocks will be uploaded again, into the same textures.
  void SetVoxels(const VoxelValues& newValues);

  /// Sets the flags that remove voxels, in addition to those that are not finite.
  void SetBlanking(const Blanking& newBlanking);
  bool MayHaveGaps() const { return !this->Texels().finite || this->blanking.Any(); }

  /// Chooses the field of values that each block has; none for no field.
  void SetValueField(vtkWindow* window, std::optional<ValueField> chosen);

  /// Says whether the device filters texels of 8 bits as exactly as wider ones.
  void SetFilter(bool filters8Bits);
  TexelFormat Format() const { return TexelFormatOf(this->values.texels, this->filters8Bits); }

  /// Decides whether each block has the gradients of its voxels.
  void SetGradients(vtkWindow* window, bool areStored);

  /// The largest memory per voxel, including the fields of voxels and cells and the gradients.
  std::size_t BytesPerVoxel() const;

  /// @return true if the division has changed; no block is resident then
  /// @throws std::runtime_error if the limits are too narrow for any block
  bool Divide(vtkWindow* window, const BlockLimits& limits);

  const BlockPartition& Partition() const { return this->partition; }
  const VoxelValues& Values() const { return this->values; }
  /// The texel format of the first component.
  const ScalarTexels& Texels() const { return this->values.texels.front(); }
  const std::vector<ScalarTexels>& TexelsOfComponents() const { return this->values.texels; }

  /// Begins an image.
  /// @param order     the blocks that the image takes, in this order
  /// @param capacity  the most memory of resident blocks from now on [bytes]
  void BeginPicture(vtkWindow* window, const std::vector<int>& order, std::size_t capacity);

  /// Returns the next block of the order, and uploads it if it is not resident.
  /// @throws std::runtime_error if the device cannot hold it
  const VolumeBlock& Take(vtkOpenGLRenderWindow* window, int block);

  std::size_t Bytes() const;
  int Uploads() const { return this->uploads; }
  /// The time that the fields of blocks have taken so far [s].
  double FieldBuildSeconds() const { return this->fieldBuildSeconds; }
  void Release(vtkWindow* window);

private:
  void ForgetVoxels();
  void LetGo(vtkWindow* window, const std::vector<int>& released);
  void Upload(vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);
  void UpdateGaps(vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);
  void UpdateValueField(
    vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);
  void UpdateGradients(
    vtkOpenGLRenderWindow* window, VolumeBlock& block, const ScalarRegion& region);

  VoxelValues values;
  Blanking blanking;
  std::optional<ValueField> valueField;
  bool filters8Bits = false;
  bool storesGradients = false;
  BlockPartition partition;
  BlockResidency residency;
  std::size_t capacity = 0;
  std::vector<std::unique_ptr<VolumeBlock>> blocks; ///< The blocks by index; null if not resident.
  int uploads = 0;
  double fieldBuildSeconds = 0.0;
};

}

#endif
