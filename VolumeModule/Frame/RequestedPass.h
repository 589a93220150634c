#ifndef Varimarch_Frame_RequestedPass_h
#define Varimarch_Frame_RequestedPass_h

#include "Core/Recipe/RenderSettings.h"

#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"

class vtkAbstractVolumeMapper;
class vtkOpenGLRenderPass;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The least opacity that is selected, as in vtkOpenGLGPUVolumeRayCastMapper.
constexpr float LeastPickedOpacity = 3.0f / 255.0f;

/// The opacity at which an image of depths records the depth of a ray.
constexpr float LeastDepthOpacity = 1e-3f;

/// The purpose of a drawing: the image, a layer between translucent geometry, or a selection.
struct RequestedPass
{
  RayPass kind = RayPass::Whole;
  vtkOpenGLRenderPass* renderPass = nullptr; ///< The pass that peels depths, or null.
  float propColor[3] = { 0.0f, 0.0f, 0.0f }; ///< The colour of the volume in a selection.
  bool picksCells = false;                   ///< True if cells are selected, not points.
  bool highestBits = false;                  ///< True for the bits of an id above the lowest 24.
};

RequestedPass PassOfVolume(
  vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// A scope guard for vtkHardwareSelector::BeginRenderProp and EndRenderProp. Without a selector it
/// does nothing.
class SelectorScope
{
public:
  explicit SelectorScope(vtkHardwareSelector* selector)
    : selector(selector)
  {
    if (selector)
    {
      selector->BeginRenderProp();
    }
  }

  SelectorScope(const SelectorScope&) = delete;
  void operator=(const SelectorScope&) = delete;

  ~SelectorScope()
  {
    if (this->selector)
    {
      this->selector->EndRenderProp();
    }
  }

  /// Reports the numbers of points and cells: ids of more than 24 bits need further passes.
  void ReportCounts(vtkDataSet* input)
  {
    if (this->selector && this->selector->GetCurrentPass() >= vtkHardwareSelector::POINT_ID_LOW24)
    {
      this->selector->UpdateMaximumPointId(input->GetNumberOfPoints());
      this->selector->UpdateMaximumCellId(input->GetNumberOfCells());
    }
  }

private:
  vtkHardwareSelector* selector;
};

}

#endif
