#include "Frame/RequestedPass.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <string>

namespace varimarch
{

namespace
{

// The layers that a render pass needs from a volume. VTK offers no getter, but the text that the
// pass would insert into a shader declares the uniforms that it will set, and so reveals the layer.
// Our shaders declare those uniforms in files of their own, so the text itself is not used.
RayPass PassWantedBy(
  vtkOpenGLRenderPass* renderPass, vtkAbstractVolumeMapper* mapper, vtkVolume* volume)
{
  std::string vertex;
  std::string geometry;
  std::string fragment = "//VTK::DepthPeeling::Dec";
  renderPass->PreReplaceShaderValues(vertex, geometry, fragment, mapper, volume);
  const auto declares = [&](const char* name) { return fragment.find(name) != std::string::npos; };
  if (declares("lastFrontColorTex"))
  {
    return RayPass::PeelBetween;
  }
  if (declares("innerDepthTex"))
  {
    return RayPass::PeelOutside;
  }
  return declares("depthRangeTex") ? RayPass::PeelLast : RayPass::Whole;
}

RequestedPass PickOf(vtkHardwareSelector* selector)
{
  RequestedPass pick;
  const int association = selector->GetFieldAssociation();
  pick.kind = RayPass::PickProp;
  pick.picksCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const auto voxel = [&](int wanted, bool highestBits)
  {
    pick.kind = association == wanted ? RayPass::PickVoxel : RayPass::PickProp;
    pick.highestBits = highestBits;
  };
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::ACTOR_PASS:
    case vtkHardwareSelector::PROCESS_PASS:
      selector->GetPropColorValue(pick.propColor);
      break;
    case vtkHardwareSelector::POINT_ID_LOW24:
    case vtkHardwareSelector::POINT_ID_HIGH24:
      voxel(vtkDataObject::FIELD_ASSOCIATION_POINTS,
        selector->GetCurrentPass() == vtkHardwareSelector::POINT_ID_HIGH24);
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      voxel(vtkDataObject::FIELD_ASSOCIATION_CELLS,
        selector->GetCurrentPass() == vtkHardwareSelector::CELL_ID_HIGH24);
      break;
  }
  return pick;
}

}

RequestedPass PassOfVolume(
  vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (vtkHardwareSelector* selector = renderer->GetSelector())
  {
    return PickOf(selector);
  }
  RequestedPass found;
  vtkInformation* keys = volume->GetPropertyKeys();
  const int count = keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())
    ? keys->Length(vtkOpenGLRenderPass::RenderPasses())
    : 0;
  for (int i = 0; i < count && found.kind == RayPass::Whole; ++i)
  {
    auto* renderPass =
      vtkOpenGLRenderPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i));
    if (renderPass)
    {
      found.kind = PassWantedBy(renderPass, mapper, volume);
      found.renderPass = renderPass;
    }
  }
  return found;
}

}
