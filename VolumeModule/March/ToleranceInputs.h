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
  std::vector<double> rule;        ///< Other inputs of the choice of the rule, without voxels.
  std::vector<double> voxels;      ///< The voxels of each volume, and the values told apart.
  std::vector<double> scene;       ///< Other inputs of the image in any view.
  std::vector<CornersClip> view;   ///< The corners of the volumes in the view.

  /// Adds the inputs of one volume.
  void Add(const VolumeMarch& march, const VolumeResources& volume);

  bool HasRuleOf(const ToleranceInputs& other) const
  {
    return this->recipe == other.recipe && this->rule == other.rule;
  }
  bool HasSceneOf(const ToleranceInputs& other) const
  {
    return this->HasRuleOf(other) && this->voxels == other.voxels && this->scene == other.scene;
  }
  bool operator==(const ToleranceInputs& other) const
  {
    return this->HasSceneOf(other) && this->view == other.view;
  }
  /// True if the scene is the same, and the view nearly the same.
  bool IsNear(const ToleranceInputs& other) const;
};

}

#endif
