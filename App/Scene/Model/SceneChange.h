#ifndef Varimarch_Scene_SceneChange_h
#define Varimarch_Scene_SceneChange_h

#include "Scene/Model/Scene.h"

class vtkImageData;

namespace varimarch
{

// The stages of a change that a movie shows, by the part of it that is done, [0, 1].

/// The cuts on their way from the outside of a volume to their places: the box closes, and planes
/// come along their normals. Scissors and masks have no way, and are there from the beginning.
SceneCuts CutsOnTheirWay(const SceneCuts& cuts, vtkImageData* image, double part);

/// True if a look can change into another one: both are composites without regions.
bool CanChange(const Look& from, const Look& to);

/// A look between two whose values have the same unit: opacities and light are mixed, and colours
/// by the opacities that they have. Curves are sampled between their nodes. Requires CanChange.
Look LookBetween(const Look& from, const Look& to, double part);

}

#endif
