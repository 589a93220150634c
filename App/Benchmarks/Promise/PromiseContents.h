#ifndef Varimarch_Promise_PromiseContents_h
#define Varimarch_Promise_PromiseContents_h

#include "PromiseScene.h"

/// Contents of voxels, and functions for them. All choose by the scene's dice.
namespace varimarch::promise
{

PromiseContent Noise(Dice& dice);
PromiseContent Lumps(Dice& dice);
PromiseContent Ball(Dice& dice, glm::ivec3 size);
PromiseContent Sheets(Dice& dice); ///< dense sheets one voxel thin in faint matter
PromiseContent Wires(Dice& dice);  ///< one voxel wide
PromiseContent Walls(Dice& dice);  ///< between nodes of lattices of every second voxel
PromiseContent Distances(Dice& dice, glm::ivec3 size); ///< rise by the same for each voxel
PromiseContent Columns(Dice& dice);                    ///< noise in each second one
PromiseContent AnyContent(Dice& dice, glm::ivec3 size);

glm::ivec3 Size(Dice& dice, int least, int most);
glm::dvec3 Spacing(Dice& dice); ///< [mm], mostly anisotropic

PromiseNodes Ramp(Dice& dice);
PromiseNodes ThinPeak(Dice& dice);
PromiseNodes Steps(Dice& dice);
PromiseNodes Opaque(Dice& dice);
/// A faint peak in the middle between voxels of Distances.
PromiseNodes Bands(Dice& dice, int voxels);
PromiseNodes Dense(Dice& dice); ///< faint, and dense for the largest values
PromiseNodes AnyNodes(Dice& dice);

}

#endif
