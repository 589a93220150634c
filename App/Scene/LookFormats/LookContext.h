#ifndef Varimarch_Scene_LookContext_h
#define Varimarch_Scene_LookContext_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Curves are sampled into a table, so more nodes than this cannot be seen.
constexpr std::size_t MostLookNodes = 10000;

/// What looks of other programs leave to the volume and to the look that they take the place of.
struct LookContext
{
  double smallest = 0.0; ///< value of the volume
  double largest = 1.0;
  double meanSpacingMm = 1.0;
  std::vector<OpacityNode> opacities = {}; ///< stay where a file holds colours alone; may be none
};

LookContext ContextOf(vtkImageData* image);

/// What a look in a file is called: "bone" in "folder/bone.vp.json".
std::string NameOfLookFile(const std::string& path);

/// Puts the nodes of a look in order and brings their numbers into their ranges: files in use need
/// it. A look without opacities gets those of the context.
/// @param file  names the look, and errors
/// @throws std::runtime_error one sentence, where there are no colours or no opacities, or numbers
///         that are not finite
Look CleanLook(Look look, const std::string& file, const LookContext& context);

/// Moves what a file says on the scale from 0 to 1 to the values that it is meant for.
void Spread(Look& look, double zero, double one);

/// Gives a gradient opacity of VTK, in units of the data per mean spacing, to a look; one that is 1
/// everywhere is none.
void TakeGradientOpacities(
  const std::vector<OpacityNode>& nodes, const LookContext& context, Look& look);

/// The other way; 1 everywhere where the look has none.
std::vector<OpacityNode> GradientOpacitiesPerSpacing(const Look& look, const LookContext& context);

/// "Cannot read FILE: MESSAGE."
[[noreturn]] void FailToReadLook(const std::string& file, const std::string& message);

}

#endif
