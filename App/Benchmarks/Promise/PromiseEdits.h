#ifndef Varimarch_Promise_PromiseEdits_h
#define Varimarch_Promise_PromiseEdits_h

#include "PromiseScene.h"

/// Things that programs do between two pictures. Each function adds edits to a scene, which are
/// done one by one.
namespace varimarch::promise
{

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
