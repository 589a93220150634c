#ifndef Varimarch_Resources_FieldResources_h
#define Varimarch_Resources_FieldResources_h

#include "Core/Fields/FieldDirections.h"
#include "Frame/MarchPlan.h"
#include "Resources/FieldTexture.h"
#include "Resources/MaterialResources.h"
#include "Resources/VolumeBlocks.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace varimarch
{

/// The source of a field, which must be built again when any of it differs.
struct FieldSource
{
  Acceleration acceleration;
  int volumeBuild; ///< The number of the volume's voxels.
  int tableBuild;  ///< The number of the optical table; 0 for a field that does not use it.
  double tolerance;
  double sense = 0.0; ///< For extremes: 1 for the largest, -1 for the smallest.
  Marcher marcher = Marcher::Device;
  std::vector<double> isovalues = {};
  glm::ivec3 towards = glm::ivec3(0); ///< The directions of its rays, see FieldDirections.

  bool operator==(const FieldSource& other) const
  {
    return this->ShowsSame(other) && this->towards == other.towards;
  }

  /// True if the same bricks are invisible, whatever the directions of rays.
  bool ShowsSame(const FieldSource& other) const
  {
    return this->isovalues == other.isovalues && this->acceleration == other.acceleration &&
      this->volumeBuild == other.volumeBuild && this->tableBuild == other.tableBuild &&
      this->tolerance == other.tolerance && this->sense == other.sense &&
      this->marcher == other.marcher;
  }
};

/// The values that the numbers of a field of extremes stand for.
struct ExtremeSteps
{
  double sense; ///< 1 for the largest, -1 for the smallest.
  double firstValue;
  double valuePerStep;
};

/// The inputs of a field.
struct FieldInputs
{
  const VolumeMarch& march;
  VolumeBlocks& blocks; ///< Each block has the scalar field of its cells.
  const MaterialResources& materials;
  int volumeBuild;
};

/// The field of the acceleration mode: the parts of a volume that rays may leave out. It is built
/// again when its source has changed; a mode that needs none releases it.
class FieldResources
{
public:
  /// @throws std::runtime_error if the device cannot hold the field
  void Update(const FieldInputs& inputs);

  /// The next field is built with new ranges of bricks: the volume has another grid.
  void ForgetBricks();

  const AccelerationField& OfBricks() const { return this->field; }
  AccelerationField& OfBricks() { return this->field; }
  ExtremeSteps ExtremeStepsOf(Blend blend) const;

  int Builds() const { return this->builds; }
  int RangesBuilds() const { return this->rangesBuilds; }
  double BuildSeconds(const VolumeBlocks& blocks) const;
  std::size_t Bytes() const { return this->field.Bytes(); }
  void Release(vtkWindow* window);

private:
  void UpdateScalarField(const FieldInputs& inputs);
  void UpdateOpticalField(const FieldInputs& inputs);
  void UpdateExtremes(const FieldInputs& inputs);
  void UpdateIsosurfaceField(const FieldInputs& inputs);
  bool BeginsField(const FieldInputs& inputs, FieldSource& source);
  void UpdateRanges(const FieldInputs& inputs);

  AccelerationField field;
  std::optional<FieldSource> madeFrom; ///< Nothing if there is no field.
  FieldDirections directions;
  int rangesOfVolume = 0; ///< The number of the volume that the ranges of bricks belong to.
  int builds = 0;         ///< A field for rays of other directions does not count.
  int rangesBuilds = 0;
};

}

#endif
