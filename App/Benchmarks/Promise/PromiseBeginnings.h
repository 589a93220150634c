#ifndef Varimarch_Promise_PromiseBeginnings_h
#define Varimarch_Promise_PromiseBeginnings_h

#include "PromiseContents.h"

/// Scenes with a volume, a look and a view, from which kinds go on.
namespace varimarch::promise
{

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

}

#endif
