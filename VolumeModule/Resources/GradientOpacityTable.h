#ifndef Varimarch_Resources_GradientOpacityTable_h
#define Varimarch_Resources_GradientOpacityTable_h

#include "Frame/MarchPlan.h"
#include "Resources/FloatTable.h"
#include "Resources/VolumeTexture.h"

#include <vector>

namespace varimarch
{

/// The gradient opacity curves, one for each material of a mixture or each row of labels. Each
/// entry of the table has the values of four curves. Empty unless the settings have gradient
/// opacity.
class GradientOpacityTable
{
public:
  /// Entries per curve. With this many, the error for a piecewise linear function is too small for
  /// a display.
  static constexpr int EntriesPerCurve = 4096;

  /// Makes the table if a curve, or the range of the gradients, has changed.
  /// @param texels  the texel format of each component of the volume
  void Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);

  MarchTexture Texture() const { return this->table.Texture(); }
  /// The gradient of the last entry of a part's curve.
  double LastGradient(std::size_t part) const { return this->lastGradients[part]; }
  std::size_t Bytes() const { return this->table.Bytes(); }
  void Release(vtkWindow* window);

private:
  FloatTable table;
  std::vector<double> lastGradients;
  Fingerprint source; ///< The inputs of the table; empty if there is none.
};

}

#endif
