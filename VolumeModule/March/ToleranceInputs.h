#ifndef Varimarch_March_ToleranceInputs_h
#define Varimarch_March_ToleranceInputs_h

#include "Core/Geometry/ProjectedBox.h"
#include "Resources/VolumeResources.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Everything that the result of a tolerance search depends on.
struct ToleranceInputs
{
  std::vector<std::string> recipe; ///< The shader files of the request.
  Fingerprint rule;                ///< Other inputs of the choice of the rule, without voxels.
  Fingerprint voxels;              ///< The voxels of each volume, and the values told apart.
  Fingerprint scene;               ///< Other inputs of the image in any view.
  Fingerprint casters;             ///< The geometry that casts shadows on the volumes.
  std::vector<CornersClip> view;   ///< The corners of the volumes in the view.

  /// Adds the inputs of one volume.
  void Add(const VolumeMarch& march, const VolumeResources& volume);

  bool HasRuleOf(const ToleranceInputs& other) const
  {
    return this->recipe == other.recipe && this->rule == other.rule;
  }
  /// True if the scene is the same but for the places of geometry that casts shadows.
  bool HasVolumesOf(const ToleranceInputs& other) const
  {
    return this->HasRuleOf(other) && this->voxels == other.voxels && this->scene == other.scene;
  }
  bool operator==(const ToleranceInputs& other) const
  {
    return this->HasVolumesOf(other) && this->casters == other.casters && this->view == other.view;
  }
};

/// True if two views, each the corners of all volumes, are nearly the same.
bool IsNear(const std::vector<CornersClip>& view, const std::vector<CornersClip>& other);

}

#endif
