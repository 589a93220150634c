#ifndef Varimarch_Testing_SmallStudy_h
#define Varimarch_Testing_SmallStudy_h

#include "Viewer/Model/SceneModel.h"

/// A torso of 32 x 28 x 20 voxels, as a loader brings it.
inline std::shared_ptr<const varimarch::Study> SmallStudy()
{
  using namespace varimarch;
  LoadedVolume volume = LoadVolume(ProceduralSource{ ProceduralKind::Torso, { 32, 28, 20 }, 1 });
  ImageStatistics statistics(volume.image);
  return std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

#endif
