#ifndef Varimarch_Frame_MaterialFunctions_h
#define Varimarch_Frame_MaterialFunctions_h

#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/Fingerprint.h"

#include <array>
#include <optional>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace varimarch
{

/// A transfer function, and the component that it is applied to.
struct MaterialFunction
{
  int component;
  TransferFunction transferFunction;
  bool decidesOnOpacity; ///< False if it has colours only.
};

/// The functions of a volume's property, as they are when a frame is built, and the fingerprints of
/// what they are made from. The image belongs to the caller.
struct MaterialFunctions
{
  /// The functions of the materials: one for each independent component; for two dependent
  /// components one of colours, then one of opacities; for RGBA one of opacities; for labels one
  /// for each row. One that shows nothing stands for a transfer function of two values.
  std::vector<MaterialFunction> ofMaterials;
  /// The function of the property's first component, whatever the settings make of it.
  TransferFunction first = TransferFunction({}, {}, 1.0);
  std::optional<TransferFunction> ofIsosurfaces; ///< Only for isosurfaces.
  vtkImageData* twoValues =
    nullptr; ///< The transfer function of two values; null if there is none.
  /// The gradient opacity of each material of a mixture, or of each row of labels: a function
  /// without colours, or none for a curve that is 1 everywhere. Empty without gradient opacity.
  std::vector<std::optional<TransferFunction>> gradientOpacities;
  /// The distances over which the opacities of components hold [mm]; that of the first for a
  /// component without opacities of its own.
  std::array<double, 4> opacityUnitDistancesMm = { 1.0, 1.0, 1.0, 1.0 };

  Fingerprint inputs;      ///< Everything that the functions of values are made from.
  Fingerprint tableInputs; ///< The same, and the property: tables of another one are made anew.
  Fingerprint gradientOpacityInputs;
  Fingerprint ofProperty; ///< The property, and the times of all of its functions.
};

/// The functions of a property.
/// @param settings          complete but for the plan of the march
/// @param surfaceComponent  the component that has the isosurfaces
/// @throws std::invalid_argument if a function has numbers without a meaning
MaterialFunctions MaterialFunctionsOf(
  vtkVolumeProperty* property, const RenderSettings& settings, int surfaceComponent);

}

#endif
