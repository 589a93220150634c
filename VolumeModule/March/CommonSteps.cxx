// Steps that several mappers share, each of which draws a part of one volume.

#include "Frame/FrameBuilder.h"
#include "March/LevelOfDetail.h"
#include "March/MapperInternals.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <exception>
#include <optional>

// Faults are those of the drawing that follows, which reports them.
bool vtkVariationFieldVolumeMapper::FindSteps(
  vtkRenderer* renderer, vtkVolume* volume, double& sampleDistance, bool& preIntegration)
{
  try
  {
    // The renderer moves lights with the camera only while it draws.
    if (renderer->GetLightFollowCamera())
    {
      renderer->UpdateLightsGeometryToFollowCamera();
    }
    std::optional<varimarch::Frame> frame = varimarch::BuildFrame(this, renderer, volume);
    if (!frame || varimarch::IsInteractive(this, volume, *frame))
    {
      return false;
    }
    frame->settings.sceneGeometry = false;
    frame->view.window->MakeCurrent();
    const std::optional<varimarch::CommonSteps> found = this->Private->Marcher.FindSteps(*frame);
    if (found)
    {
      sampleDistance = found->sampleDistanceMm;
      preIntegration = found->isPreIntegrated;
    }
    return found.has_value();
  }
  catch (const std::exception&)
  {
    return false;
  }
}

void vtkVariationFieldVolumeMapper::SetCommonSteps(double sampleDistance, bool preIntegration)
{
  std::optional<varimarch::CommonSteps> steps;
  if (sampleDistance > 0.0)
  {
    steps = { sampleDistance, preIntegration };
  }
  this->Private->Marcher.SetCommonSteps(steps);
}
