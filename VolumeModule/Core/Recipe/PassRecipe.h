#ifndef Varimarch_Core_Recipe_PassRecipe_h
#define Varimarch_Core_Recipe_PassRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The part of a shader's recipe that says what becomes of a ray.

std::string BlendFile(const RenderSettings& settings);
/// The files of the vertex shader, which is the same for all recipes.
std::vector<std::string> VertexShaderParts();

std::string ResumeFile(RayPass pass);
std::string MarchedFile(RayPass pass);
std::string LocateFile(RayPass pass);
std::string PeelFile(RayPass pass);
std::string WindowFile(const RenderSettings& settings);

/// Its files behind those that march a ray.
std::vector<std::string> PassParts(const RenderSettings& settings);

/// All files of a shader whose rays the processor marches.
std::vector<std::string> PacketParts(const RenderSettings& settings);

}

#endif
