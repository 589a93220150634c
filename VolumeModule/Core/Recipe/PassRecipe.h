#ifndef Varimarch_Core_Recipe_PassRecipe_h
#define Varimarch_Core_Recipe_PassRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Files of a shader that determine what happens to a ray before and after its march.

std::string BlendFile(const RenderSettings& settings);
/// The files of the vertex shader, which is the same for all recipes.
std::vector<std::string> VertexShaderParts();

std::string ResumeFile(RayPass pass);
std::string MarchedFile(RayPass pass);
std::string LocateFile(RayPass pass);
std::string PeelFile(RayPass pass);
std::string WindowFile(const RenderSettings& settings);

/// The files that follow the march.
std::vector<std::string> PassParts(const RenderSettings& settings);

/// All files of a shader for rays that are marched on the CPU.
std::vector<std::string> PacketParts(const RenderSettings& settings);

/// The files of a shader that reads the volume along rays to lights only, for
/// ShaderRole::LightPlaces.
std::vector<std::string> LightPlacesParts(const RenderSettings& settings);

}

#endif
