#ifndef Varimarch_Scene_LookContext_h
#define Varimarch_Scene_LookContext_h

#include "Scene/Model/Scene.h"

#include <vtkNew.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkXMLDataElement;
class vtkXMLDataParser;

namespace varimarch
{

/// Curves are sampled into a table, so more nodes than this would not be visible.
constexpr std::size_t MostLookNodes = 10000;

/// Facts that other programs' looks take from the volume and from the current look.
struct LookContext
{
  double smallest = 0.0; ///< range of the volume's values
  double largest = 1.0;
  double meanSpacingMm = 1.0;
  std::vector<OpacityNode> opacities = {}; ///< the current look's, for files without opacities
};

LookContext ContextOf(vtkImageData* image);

/// The file name without folder and extension: "bone" for "folder/bone.vp.json".
std::string NameOfLookFile(const std::string& path);

/// Sorts the nodes of a look and clamps its numbers to their ranges, which real files often
/// violate. A look without opacities gets those of the context.
/// @param file  name of the look, and of the file in errors
/// @throws std::runtime_error with one sentence if colours or opacities are missing, or numbers are
///         not finite
Look CleanLook(Look look, const std::string& file, const LookContext& context);

/// Maps the values of a look from [0, 1] to [zero, one].
void Spread(Look& look, double zero, double one);

/// Sets a look's gradient opacities from VTK's, which are in units of the data per mean spacing.
/// Opacities that are 1 everywhere are dropped.
void TakeGradientOpacities(
  const std::vector<OpacityNode>& nodes, const LookContext& context, Look& look);

/// The inverse: gradient opacities in VTK's units; 1 everywhere if the look has none.
std::vector<OpacityNode> GradientOpacitiesPerSpacing(const Look& look, const LookContext& context);

/// Throws "Cannot read FILE: MESSAGE."
[[noreturn]] void FailToReadLook(const std::string& file, const std::string& message);

/// A parsed XML text, which owns its elements.
class LookXml
{
public:
  /// @param file  name of the file in errors
  /// @throws std::runtime_error with one sentence if the text is not valid XML
  LookXml(const std::string& text, const std::string& file);
  ~LookXml();
  LookXml(const LookXml&) = delete;
  void operator=(const LookXml&) = delete;

  vtkXMLDataElement* Root() const;

private:
  vtkNew<vtkXMLDataParser> parser;
};

/// Elements of a name at any depth, including the top. The name is in lower case; the case of the
/// elements' names does not matter.
std::vector<vtkXMLDataElement*> ElementsNamed(vtkXMLDataElement* top, const std::string& name);

}

#endif
