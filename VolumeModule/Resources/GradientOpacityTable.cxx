#include "Resources/GradientOpacityTable.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"
#include "Resources/MaterialTables.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace varimarch
{

namespace
{

// Opacity curves; a null pointer stands for a curve that is 1 everywhere.
using Curves = std::vector<vtkPiecewiseFunction*>;

// The curve of each material of a mixture, or of each row of labels.
Curves GradientOpacitiesOf(vtkVolumeProperty* property, const RenderSettings& settings)
{
  Curves curves;
  for (int part = 0; part < PartCount(settings); ++part)
  {
    const bool has =
      property->HasGradientOpacity(part) && !property->GetDisableGradientOpacity(part);
    curves.push_back(has ? property->GetGradientOpacity(part) : nullptr);
  }
  if (settings.mask == Mask::Labels)
  {
    for (const int label : LabelsOf(property))
    {
      vtkPiecewiseFunction* const own = property->GetLabelGradientOpacity(label);
      curves.push_back(own ? own : curves.front());
    }
  }
  return curves;
}

/// The gradient of the last entry of a curve: the last at which it changes, at most that at which
/// VTK's gradient opacity saturates.
double LastGradientOf(vtkPiecewiseFunction* function, double saturated)
{
  if (!function)
  {
    return saturated;
  }
  const TransferFunction curve = OpacityCurveOf(function);
  const double last = curve.ChangingValues().value_or(ValueRange{ 0.0, 0.0 }).upper;
  // A step at the end needs one more entry.
  const double entry = saturated / GradientOpacityTable::EntriesPerCurve;
  const double end = curve.HasStepAt(last) ? last + entry : last;
  return end > 0.0 ? std::min(end, saturated) : saturated;
}

/// The last gradient of each curve, or the largest one for all curves of labels.
/// @param saturated  the gradient at which the opacity of each component saturates
std::vector<double> LastGradients(const Curves& curves, const std::vector<double>& saturated)
{
  std::vector<double> last(saturated.size(), 0.0);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const std::size_t part = std::min(i, last.size() - 1);
    last[part] = std::max(last[part], LastGradientOf(curves[i], saturated[part]));
  }
  return last;
}

/// The entries of a table. Each entry has the values of four curves.
/// @param largest  the gradient of the last entry of each curve; one for all curves of labels
std::vector<glm::vec4> GradientOpacityEntries(
  const Curves& curves, const std::vector<double>& largest)
{
  const std::size_t groups = (curves.size() + 3) / 4;
  std::vector<glm::vec4> entries(groups * GradientOpacityTable::EntriesPerCurve, glm::vec4(1.0f));
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i])
    {
      const TransferFunction curve = OpacityCurveOf(curves[i]);
      const double last = largest[std::min(i, largest.size() - 1)];
      for (int entry = 0; entry < GradientOpacityTable::EntriesPerCurve; ++entry)
      {
        const double gradient = last * entry / (GradientOpacityTable::EntriesPerCurve - 1);
        entries[i / 4 * GradientOpacityTable::EntriesPerCurve + entry][int(i % 4)] =
          float(curve.Opacity(gradient));
      }
    }
  }
  return entries;
}

}

void GradientOpacityTable::Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  if (!march.settings.gradientOpacity)
  {
    this->Release(march.frame.view.window);
    return;
  }
  std::vector<double> saturated;
  const Curves curves = GradientOpacitiesOf(march.frame.material.property, march.settings);
  Fingerprint inputs(march.frame.material.property->GetMTime());
  for (vtkPiecewiseFunction* curve : curves)
  {
    inputs.Add(Fingerprint(curve, curve ? curve->GetMTime() : 0));
  }
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    const int component = OpacityComponentOf(march.settings, part);
    saturated.push_back(LargestGradient(texels[component]));
  }
  inputs.Add(saturated);
  if (this->source != inputs)
  {
    this->lastGradients = LastGradients(curves, saturated);
    this->table.Set(march.frame.view.window, GradientOpacityEntries(curves, this->lastGradients));
    this->source = inputs;
  }
  this->table.Update(march.frame.view.window, march.plan.marcher);
}

void GradientOpacityTable::Release(vtkWindow* window)
{
  this->table.Release(window);
  this->source = {};
}

}
