#ifndef Varimarch_Frame_SelectorScope_h
#define Varimarch_Frame_SelectorScope_h

#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"

namespace varimarch
{

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
