#include "Support/RecipesOfVolumes.h"

namespace varimarch
{

std::vector<RenderSettings> RecipesOfSeveralVolumes()
{
  RenderSettings one;
  one.overlaps = true;
  RenderSettings lit = one;
  lit.shading = true;
  lit.gradientOpacity = true;
  RenderSettings nearest{ Blend::Composite, Acceleration::Off };
  nearest.overlaps = true;
  nearest.nearest = true;
  RenderSettings mixture = lit;
  mixture.lights = true;
  mixture.components = Components::Independent;
  mixture.componentCount = 3;
  RenderSettings two = one;
  two.acceleration = Acceleration::CellField;
  two.functionOf = FunctionOf::ValueAndGradient;
  two.cubic = true;
  std::vector<RenderSettings> recipes;
  const auto add = [&](RenderSettings first, const std::vector<RenderSettings>& others)
  {
    first.others = others;
    recipes.push_back(first);
  };
  add(one, { one });
  RenderSettings spanned = one;
  spanned.limitsSpan = true;
  add(spanned, { one });
  add(one, { lit });
  add(lit, { nearest });
  add(nearest, { nearest, nearest });
  add(mixture, { two, one, lit });
  RenderSettings cut = one;
  cut.clipping = true;
  cut.sceneGeometry = true;
  cut.jitter = true;
  add(cut, { one });
  cut.pass = RayPass::PeelBetween;
  add(cut, { one });
  return recipes;
}

std::vector<RenderSettings> RecipesOfVolumesInLight()
{
  RenderSettings lit;
  lit.overlaps = lit.shading = lit.lights = true;
  lit.shadows = lit.softLights = lit.casters = lit.shadowsOthers = true;
  lit.components = Components::Independent;
  lit.componentCount = 3;
  RenderSettings unlit;
  unlit.overlaps = unlit.shadowsOthers = true;
  RenderSettings boxes = unlit;
  boxes.nearest = true;
  RenderSettings first = lit;
  first.others = { unlit, boxes };
  RenderSettings cut = unlit;
  cut.clipping = true;
  cut.others = { lit, lit };
  RenderSettings occluded = lit;
  occluded.shadows = occluded.softLights = occluded.casters = occluded.shadowsOthers = false;
  occluded.occlusion = occluded.occludesOthers = true;
  RenderSettings dimmed = occluded;
  dimmed.components = Components::One;
  dimmed.shadows = dimmed.shadowsOthers = dimmed.clipping = true;
  boxes.occlusion = boxes.occludesOthers = true;
  dimmed.others = { boxes };
  boxes.shadowsOthers = false;
  occluded.others = { boxes, boxes };
  return { first, cut, occluded, dimmed };
}

}
