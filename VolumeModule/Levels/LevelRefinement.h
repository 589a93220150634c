#ifndef Varimarch_Levels_LevelRefinement_h
#define Varimarch_Levels_LevelRefinement_h

#include "Core/Blocks/VoxelUnits.h"
#include "Core/Fields/VolumeSummary.h"
#include "Core/Quality/BlockLooks.h"
#include "Core/Quality/LevelBound.h"
#include "Frame/Frame.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace varimarch
{

/// Everything that the errors of levels in an image follow from, as copies: a program may ask for
/// them when the camera, the look or the whole scene has changed.
struct LevelInputs
{
  std::shared_ptr<const VolumeSummary> summary;
  std::vector<MiddleLevel> middle; ///< See BlockLooks.
  VoxelType type;
  TransferFunction look;
  ValueRange resolved;           ///< See ScalarTexels.
  Fingerprint volumeFingerprint; ///< See VolumeFingerprint.
  PixelRays rays;
  glm::ivec2 pixels;
  glm::dmat3 worldFromGrid;
  Box boxGrid;
  std::optional<double> brightest; ///< See BlockLooks.
  std::vector<LevelLight> lights;  ///< Everything that matter may keep from a place.
  bool hasSoftLamps;               ///< True if soft lamps near the volume cast shadows.
  double memoryBytes;              ///< The memory that voxels may take [bytes].
  std::optional<VoxelUnits> units; ///< The units in which voxels are read; none if by pages.

  BlockLooks Looks() const;
  bool HasLooksOf(const LevelInputs& other) const
  {
    return this->volumeFingerprint == other.volumeFingerprint && this->brightest == other.brightest;
  }

  /// @param endsEarlier  see LevelBoundScene
  LevelBoundScene SceneOf(const BlockLooks& looks, bool endsEarlier) const
  {
    return { looks, this->rays, this->pixels, this->worldFromGrid, this->boxGrid, endsEarlier,
      this->lights };
  }
};

/// The inputs of a frame of voxels; none if more than the values along its rays decides on the
/// image, so that ranges bound nothing.
/// @param summary  that of the voxels, with a coarse level
/// @param middle   see BlockLooks
std::optional<LevelInputs> LevelInputsOf(const std::shared_ptr<const VolumeSummary>& summary,
  const std::vector<MiddleLevel>& middle, const Frame& frame);

/// A bound of the error of an image of the coarse level alone, in about a second.
double BoundOfLevelAlone(const LevelInputs& inputs);

/// The levels by which the blocks of a scene are drawn: with each round finer ones where the image
/// needs them most, until the error of all is within a tolerance. Each round doubles the voxels at
/// most, and the one after those that fit in memory is the last: since its voxels are read anew for
/// each image, there is one image of them only.
class LevelRefinement
{
public:
  /// @param fingerprint  that of the image, see ImageFingerprint
  /// @param sameLooks  the refinement of another view whose HasLooksFor(inputs) is true; may be
  /// null
  LevelRefinement(
    Fingerprint fingerprint, const LevelInputs& inputs, const LevelRefinement* sameLooks);

  bool IsOf(const Fingerprint& otherFingerprint) const
  {
    return this->fingerprint == otherFingerprint;
  }

  /// True if the looks of blocks are known, and are those of the inputs.
  bool HasLooksFor(const LevelInputs& others) const
  {
    return this->looks && this->inputs.HasLooksOf(others);
  }

  /// Goes a round on, unless the bound is at most the tolerance.
  void Refine(double tolerance);

  const std::shared_ptr<const BlockLevels>& Levels() const { return this->levels; }
  int Rounds() const { return this->rounds; }
  /// A bound of the error of the levels; 1 before the first round.
  double Bound() const { return this->bound; }
  std::size_t VisibleBlocks() const { return this->visible; }
  /// The number of visible blocks that are drawn by voxels.
  std::size_t RefinedBlocks() const { return this->refined; }
  /// False if the voxels of a next round may not fit in memory, so that it is the last.
  bool NextFits() const { return 2.0 * this->heldBytes <= this->inputs.memoryBytes; }

private:
  /// Finds the bounds of an image that has voxels only where they are invisible.
  void Begin();
  /// The voxels of a block, and those that are read for all blocks that are drawn by voxels
  /// [bytes].
  double BlockBytes() const;
  double HeldBytes() const;
  /// The aim of the next round.
  RefinementRound NextRound(double tolerance) const;

  Fingerprint fingerprint;
  LevelInputs inputs;
  std::vector<double> bounds;              ///< The bounds of all pixels, after the first round.
  std::shared_ptr<const BlockLooks> looks; ///< May be null before the first round.
  std::shared_ptr<const BlockLevels> levels;
  double bound = 1.0;
  int rounds = 0;
  std::size_t visible = 0;
  std::size_t refined = 0;
  double heldBytes = 0.0;
};

}

#endif
