#ifndef Varimarch_Benchmarks_FeatureList_h
#define Varimarch_Benchmarks_FeatureList_h

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// A pipeline on which features are switched on and off by the same calls for every mapper.
struct FeatureStage
{
  vtkGPUVolumeRayCastMapper* mapper;
  vtkVolume* volume;
  vtkRenderer* renderer;
  vtkImageData* image; ///< input without any feature
};

/// A feature that users of VTK switch on, and the state it is compared with.
struct Feature
{
  using Switch = std::function<void(const FeatureStage&)>;

  std::string name; ///< name on the command line and in tables
  std::string over; ///< description of the state that it is compared with
  Switch prepare;   ///< sets the state that it is compared with
  Switch switchOn;
  Switch switchOff;   ///< restores the prepared state
  bool isVtks = true; ///< false if VTK's mapper lacks it; its times are then meaningless
};

/// The features that `varimarch-bench features` measures.
const std::vector<Feature>& Features();

std::vector<std::string> FeatureNames();

}

#endif
