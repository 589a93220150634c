#ifndef Varimarch_Resources_GradientOpacityTable_h
#define Varimarch_Resources_GradientOpacityTable_h

#include "Frame/MarchPlan.h"
#include "Resources/FloatTable.h"
#include "Resources/VolumeTexture.h"

#include <vector>

namespace varimarch
{

/// The curves of opacities by gradients, four in each entry of a table: one for each material of a
/// mixture, or for each row of labels. Only there if the settings have gradient opacity.
class GradientOpacityTable
{
public:
  /// Entries per curve. With so many, a piecewise linear function loses less than a display can
  /// show.
  static constexpr int EntriesPerCurve = 4096;

  /// Makes the table if a curve, or the range of the gradients, has changed.
  /// @param texels  those of each component of the volume
  void Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels);

  const FloatTable& Table() const { return this->table; }
  std::size_t Bytes() const { return this->table.Bytes(); }
  void Release(vtkWindow* window);

private:
  FloatTable table;
  std::vector<double> source; ///< The inputs of the table; empty if there is none.
};

}

#endif
