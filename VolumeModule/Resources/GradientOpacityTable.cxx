#include "Resources/GradientOpacityTable.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"
#include "Resources/MaterialTables.h"
#include "Resources/ValueFocus.h"

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

/// The gradients that matter for the table of a component's curves.
struct GradientRange
{
  double saturated; ///< that beyond which VTK's gradient opacity stays the same
  double smallest;  ///< that of the first entry behind 0, if the curve changes only at 0
};

/// The last entry of a table.
constexpr int LastEntry = GradientOpacityTable::EntriesPerCurve - 1;

/// The gradient of the last entry that a curve needs: the last at which it changes. If that is a
/// step, it is the gradient of the last entry but one. Then a step is one entry wide, however far
/// from the others some values of the volume are. 0 if the curve is the same everywhere.
double LastGradientOf(vtkPiecewiseFunction* function, const GradientRange& range)
{
  const TransferFunction curve =
    function ? OpacityCurveOf(function) : TransferFunction({}, {}, 1.0);
  const double last = curve.ChangingValues().value_or(ValueRange{ -1.0, -1.0 }).upper;
  const std::vector<Step> steps = curve.Steps();
  const bool endsInStep = std::any_of(steps.begin(), steps.end(),
    [&](const Step& step) { return step.value == last && step.valueIsLeft; });
  if (last < 0.0 || last >= range.saturated)
  {
    return last < 0.0 ? 0.0 : range.saturated;
  }
  const double end = endsInStep ? last / (LastEntry - 1) * LastEntry : last;
  return end > 0.0 ? end : range.smallest * LastEntry;
}

/// The last gradient of each component's table. All curves of labels have one.
/// @param ranges  the gradients of each component
std::vector<double> LastGradients(const Curves& curves, const std::vector<GradientRange>& ranges)
{
  std::vector<double> last(ranges.size(), 0.0);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const std::size_t part = std::min(i, last.size() - 1);
    last[part] = std::max(last[part], LastGradientOf(curves[i], ranges[part]));
  }
  for (std::size_t part = 0; part < last.size(); ++part)
  {
    last[part] = last[part] > 0.0 ? last[part] : ranges[part].saturated;
  }
  return last;
}

// The gradients of each part of a mixture.
std::vector<GradientRange> GradientRangesOf(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  const std::vector<std::optional<ValueRange>> thatMatter = ValuesThatMatter(march.frame);
  std::vector<GradientRange> ranges;
  for (int part = 0; part < PartCount(march.settings); ++part)
  {
    const int component = OpacityComponentOf(march.settings, part);
    const ValueRange all{ texels[component].smallestScalar, texels[component].largestScalar };
    const bool reachFar = thatMatter[component] && ReachFarBeyond(all, *thatMatter[component]);
    const double near = reachFar ? NearValues(all, thatMatter[component]).Width() : all.Width();
    const double saturated = LargestGradient(texels[component]);
    ranges.push_back({ saturated, near > 0.0 ? 0.25 * near / LastEntry : saturated / LastEntry });
  }
  return ranges;
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
      const std::vector<Step> steps = curve.Steps();
      const double gap = largest[std::min(i, largest.size() - 1)] / LastEntry;
      for (int entry = 0; entry <= LastEntry; ++entry)
      {
        const double gradient = SnappedToStep(steps, gap * entry, 1e-6 * gap);
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
  const Curves curves = GradientOpacitiesOf(march.frame.material.property, march.settings);
  Fingerprint inputs(march.frame.material.property->GetMTime());
  for (vtkPiecewiseFunction* curve : curves)
  {
    inputs.Add(Fingerprint(curve, curve ? curve->GetMTime() : 0));
  }
  const std::vector<GradientRange> ranges = GradientRangesOf(march, texels);
  for (const GradientRange& range : ranges)
  {
    inputs.Add(Fingerprint(range.saturated, range.smallest));
  }
  if (this->source != inputs)
  {
    this->lastGradients = LastGradients(curves, ranges);
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
