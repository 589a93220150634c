#ifndef Varimarch_Resources_FieldResources_h
#define Varimarch_Resources_FieldResources_h

#include "Core/Fields/FieldDirections.h"
#include "Frame/MarchPlan.h"
#include "Resources/FieldTexture.h"
#include "Resources/MaskTexture.h"
#include "Resources/MaterialResources.h"
#include "Resources/VolumeBlocks.h"

#include <glm/vec3.hpp>

#include <optional>
#include <tuple>
#include <vector>

namespace varimarch
{

/// The inputs that a field was built from. It must be rebuilt if any of them differs.
struct FieldSource
{
  Acceleration acceleration;
  int volumeBuild; ///< The build number of the voxels.
  int tableBuild;  ///< The build number of the optical table; 0 for a field that does not use it.
  int maskBuild;   ///< The build number of the mask; 0 for a field that does not use it.
  double tolerance;
  double sense = 0.0; ///< 1 for maxima, -1 for minima; 0 for other fields.
  Marcher marcher = Marcher::Device;
  std::vector<double> isovalues = {};
  glm::ivec3 towards = glm::ivec3(0); ///< The ray directions it is for, see FieldDirections.
};

inline auto FieldsOf(const FieldSource& source)
{
  const auto& [acceleration, volumeBuild, tableBuild, maskBuild, tolerance, sense, marcher,
    isovalues, towards] = source;
  return std::tie(acceleration, volumeBuild, tableBuild, maskBuild, tolerance, sense, marcher,
    isovalues, towards);
}

inline bool operator==(const FieldSource& one, const FieldSource& other)
{
  return FieldsOf(one) == FieldsOf(other);
}

/// True if the same bricks are invisible, regardless of ray directions.
inline bool ShowSame(FieldSource one, const FieldSource& other)
{
  one.towards = other.towards;
  return one == other;
}

/// The mapping from the steps of a field of extremes to values.
struct ExtremeSteps
{
  double sense; ///< 1 for maxima, -1 for minima.
  double firstValue;
  double valuePerStep;
};

/// The data that a field is built from.
struct FieldInputs
{
  const VolumeMarch& march;
  VolumeBlocks& blocks; ///< The blocks, each of which has the field of its values.
  const MaterialResources& materials;
  const MaskTexture& mask;
  int volumeBuild;
};

/// The field of the acceleration mode, which records the parts of a volume that rays may skip. It
/// is rebuilt when its source has changed, and released by a mode without a field.
class FieldResources
{
public:
  /// @throws std::runtime_error if the device cannot hold the field
  void Update(const FieldInputs& inputs);

  /// Discards the ranges of bricks, because the volume has another grid.
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
  void UpdateValueField(const FieldInputs& inputs);
  void UpdateOpticalField(const FieldInputs& inputs);
  void UpdateExtremes(const FieldInputs& inputs);
  void UpdateIsosurfaceField(const FieldInputs& inputs);
  bool BeginsField(const FieldInputs& inputs, FieldSource& source);
  void UpdateRanges(const FieldInputs& inputs);

  AccelerationField field;
  std::optional<FieldSource> madeFrom; ///< The source of the field; empty if there is no field.
  FieldDirections directions;
  int rangesOfVolume = 0; ///< The build number of the voxels that the ranges of bricks belong to.
  int builds = 0;         ///< Builds so far, except those for other ray directions only.
  int rangesBuilds = 0;
};

}

#endif
