#ifndef Varimarch_Testing_SmallStudy_h
#define Varimarch_Testing_SmallStudy_h

#include "Viewer/Model/SceneModel.h"

/// A loaded torso of 32 x 28 x 20 voxels.
inline std::shared_ptr<const varimarch::Study> SmallStudy()
{
  using namespace varimarch;
  LoadedVolume volume = LoadVolume(ProceduralSource{ ProceduralKind::Torso, { 32, 28, 20 }, 1 });
  ImageStatistics statistics(volume.image);
  return std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

/// A scene with a patient's name in its path, and a blue background.
inline varimarch::Scene SceneOfPatient()
{
  varimarch::Scene scene;
  scene.volume = varimarch::FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt };
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 100.0, 0.0 }, { 300.0, 0.8 } };
  scene.background = { 0.0, 0.0, 1.0 };
  return scene;
}

#endif
