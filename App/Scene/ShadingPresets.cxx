#include "Scene/ShadingPresets.h"

namespace varimarch
{

namespace
{

// With shading off, the coefficients do not matter.
bool AreAlike(const Shading& a, const Shading& b)
{
  return a.enabled == b.enabled &&
    (!a.enabled ||
      (a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
        a.specularPower == b.specularPower));
}

}

const NameTable<Shading>& ShadingPresets()
{
  static const NameTable<Shading> presets = {
    { "soft", { true, 0.35, 0.65, 0.05, 8.0 } },
    { "clinical", { true, 0.15, 0.85, 0.2, 10.0 } },
    { "glossy", { true, 0.1, 0.75, 0.6, 48.0 } },
    { "flat", { false, 1.0, 0.0, 0.0, 1.0 } },
  };
  return presets;
}

std::optional<std::string> NameOfShading(const Shading& shading)
{
  for (const auto& [name, preset] : ShadingPresets())
  {
    if (AreAlike(shading, preset))
    {
      return name;
    }
  }
  return std::nullopt;
}

}
