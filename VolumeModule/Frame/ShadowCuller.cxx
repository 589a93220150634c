#include "Frame/ShadowCuller.h"

#include "Frame/RendererVolumes.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Appends volumes that cast shadows to the list of props that earlier cullers have left. The list
// has room for all visible props.
class vtkShadowCuller : public vtkCuller
{
public:
  static vtkShadowCuller* New() { VTK_STANDARD_NEW_BODY(vtkShadowCuller); }
  vtkTypeMacro(vtkShadowCuller, vtkCuller);

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& areTimesKnown) override
  {
    double time = 0.0;
    for (int i = 0; i < count; ++i)
    {
      if (!areTimesKnown)
      {
        props[i]->SetRenderTimeMultiplier(1.0);
      }
      time += props[i]->GetRenderTimeMultiplier();
    }
    areTimesKnown = 1;
    if (renderer->GetSelector())
    {
      return time;
    }
    for (vtkVolume* volume : VolumesBackToFront(renderer))
    {
      vtkVariationFieldVolumeMapper* const mapper = DrawingMapper(volume);
      const bool casts = mapper->GetShadows() && mapper->GetShadowStrength() > 0.0;
      if (casts && std::find(props, props + count, volume) == props + count)
      {
        constexpr double SmallPart = 0.05; // it has no pixels
        volume->SetRenderTimeMultiplier(SmallPart);
        props[count++] = volume;
        time += SmallPart;
      }
    }
    return time;
  }
};

}

void KeepShadowsOutOfView(vtkRenderer* renderer)
{
  vtkCullerCollection* const cullers = renderer->GetCullers();
  vtkCollectionSimpleIterator iterator;
  cullers->InitTraversal(iterator);
  while (vtkCuller* culler = cullers->GetNextCuller(iterator))
  {
    if (vtkShadowCuller::SafeDownCast(culler))
    {
      return;
    }
  }
  if (cullers->GetNumberOfItems() > 0)
  {
    renderer->AddCuller(vtkNew<vtkShadowCuller>());
  }
}

}
