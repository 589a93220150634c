#ifndef Varimarch_March_ToleranceInputs_h
#define Varimarch_March_ToleranceInputs_h

#include "Core/Geometry/ProjectedBox.h"
#include "Resources/VolumeResources.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The lights that the result of a tolerance search depends on.
struct ToleranceLights
{
  Fingerprint colors; ///< All lights but for where they are.
  std::vector<glm::vec3>
    places; ///< The places or directions of lamps, and the axes of their cones.
  std::vector<glm::vec3> towards; ///< The directions from the middle of the volumes to lamps.

  /// Adds the lights of one volume.
  void Add(const Frame& frame);

  /// True if no lamp has moved by much.
  bool IsNear(const ToleranceLights& other) const;
  bool operator==(const ToleranceLights& other) const
  {
    return this->colors == other.colors && this->places == other.places;
  }
  bool operator!=(const ToleranceLights& other) const { return !(*this == other); }
};

/// Everything that the result of a tolerance search depends on.
struct ToleranceInputs
{
  std::vector<std::string> recipe; ///< The shader files of the request.
  Fingerprint rule;                ///< Other inputs of the choice of the rule, without voxels.
  Fingerprint voxels;              ///< The voxels of each volume, and the values told apart.
  Fingerprint scene;               ///< Other inputs of the image in any view.
  ToleranceLights lights;
  Fingerprint casters;           ///< The geometry that casts shadows on the volumes.
  std::vector<CornersClip> view; ///< The corners of the volumes in the view.

  /// Adds the inputs of one volume.
  void Add(const VolumeMarch& march, const VolumeResources& volume);

  bool HasRuleOf(const ToleranceInputs& other) const
  {
    return this->recipe == other.recipe && this->rule == other.rule;
  }
  /// True if the scene is the same but for its lights and the places of geometry that casts
  /// shadows.
  bool HasVolumesOf(const ToleranceInputs& other) const
  {
    return this->HasRuleOf(other) && this->voxels == other.voxels && this->scene == other.scene;
  }
  bool operator==(const ToleranceInputs& other) const
  {
    return this->HasVolumesOf(other) && this->lights == other.lights &&
      this->casters == other.casters && this->view == other.view;
  }
};

/// True if two views, each the corners of all volumes, are nearly the same.
bool IsNear(const std::vector<CornersClip>& view, const std::vector<CornersClip>& other);

}

#endif
