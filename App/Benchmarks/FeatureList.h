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

/// A pipeline on which a feature is switched on and off, by the same calls whoever draws.
struct FeatureStage
{
  vtkGPUVolumeRayCastMapper* mapper;
  vtkVolume* volume;
  vtkRenderer* renderer;
  vtkImageData* image; ///< the input without any feature
};

/// Something that VTK's users switch on, and what it is to be compared with.
struct Feature
{
  using Switch = std::function<void(const FeatureStage&)>;

  std::string name; ///< on the command line and in tables
  std::string over; ///< what it is added to, for people
  Switch prepare;   ///< what it is added to
  Switch switchOn;
  Switch switchOff;   ///< what is left is what was prepared
  bool isVtks = true; ///< else VTK's mapper does not have it: its times tell nothing
};

/// All that `varimarch-bench features` measures.
const std::vector<Feature>& Features();

std::vector<std::string> FeatureNames();

}

#endif
