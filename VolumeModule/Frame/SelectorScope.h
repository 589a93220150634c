#ifndef Varimarch_Frame_SelectorScope_h
#define Varimarch_Frame_SelectorScope_h

#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"

namespace varimarch
{

/// A selector counts a prop while one of these lives.
class PropOfSelector
{
public:
  explicit PropOfSelector(vtkHardwareSelector* selector)
    : selector(selector)
  {
    if (selector)
    {
      selector->BeginRenderProp();
    }
  }

  PropOfSelector(const PropOfSelector&) = delete;
  void operator=(const PropOfSelector&) = delete;

  ~PropOfSelector()
  {
    if (this->selector)
    {
      this->selector->EndRenderProp();
    }
  }

  /// Numbers of more than 24 bits take further passes.
  void TellCounts(vtkDataSet* input)
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
