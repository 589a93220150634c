#ifndef Varimarch_Promise_PromiseParts_h
#define Varimarch_Promise_PromiseParts_h

#include "PromiseScene.h"

namespace varimarch::promise
{

// Contents of voxels, and functions for them. All choose by the scene's dice.

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

// Scenes with a volume, a look and a view, from which kinds go on.

void BeginUnlit(
  PromiseScene& scene, const PromiseContent& content, glm::ivec3 size, int type = VTK_FLOAT);
void BeginAnyUnlit(PromiseScene& scene, const PromiseNodes& nodes, int type = VTK_FLOAT);
void SetGradientOpacity(PromiseScene& scene);
void BeginLit(PromiseScene& scene, const PromiseContent& content, glm::ivec3 size,
  const PromiseNodes& nodes, int type = VTK_FLOAT);
void BeginAnyLit(PromiseScene& scene);
void BeginLitBands(PromiseScene& scene);
void BeginLitSheets(PromiseScene& scene);
void BeginLitWires(PromiseScene& scene);
void BeginLitWalls(PromiseScene& scene);
void BeginLitNoise(PromiseScene& scene);
void BeginLitPetOverCt(PromiseScene& scene);
void Occlude(PromiseScene& scene);
vtkLight* CastShadows(PromiseScene& scene);
void Soften(vtkLight* light, PromiseScene& scene);

// Things that programs do between two pictures. Each function adds edits to a scene, which are
// done one by one.

void AddPans(PromiseScene& scene, int count);       ///< by a few hundredths of the picture
void AddOrbits(PromiseScene& scene, int count);     ///< by a degree or several
void AddLookEdits(PromiseScene& scene, int count);  ///< nodes moved, added or replaced
void AddDataEdits(PromiseScene& scene, int count);  ///< other values in place
void AddLightEdits(PromiseScene& scene, int count); ///< lights moved, dimmed, softened; settings
void AddMatrixEdits(PromiseScene& scene, int count);
void AddCutEdits(PromiseScene& scene, int count);  ///< planes moved, cropping switched
void AddMaskEdits(PromiseScene& scene, int count); ///< its kind, its content
void AddAnyEdits(PromiseScene& scene, int count);

}

#endif
