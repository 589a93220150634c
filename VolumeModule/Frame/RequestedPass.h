#ifndef Varimarch_Frame_RequestedPass_h
#define Varimarch_Frame_RequestedPass_h

#include "Core/Recipe/RenderSettings.h"

class vtkAbstractVolumeMapper;
class vtkOpenGLRenderPass;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// Less is not selected, by vtkOpenGLGPUVolumeRayCastMapper's measure.
constexpr float LeastPickedOpacity = 3.0f / 255.0f;

/// And the least at which an image of depths begins.
constexpr float LeastDepthOpacity = 1e-3f;

/// What a volume is drawn for: its picture, translucent geometry in it, or a selection.
struct VolumePass
{
  RayPass pass = RayPass::Whole;
  vtkOpenGLRenderPass* renderPass = nullptr; ///< that peels; else none
  float propColor[3] = { 0.0f, 0.0f, 0.0f }; ///< while picking: of the volume
  bool picksCells = false;                   ///< and not points
  bool highestBits = false;                  ///< of what is picked; else the lowest 24
};

VolumePass PassOfVolume(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

}

#endif
