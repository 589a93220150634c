#include "Resources/MaterialResources.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Resources/MaterialTables.h"
#include "Resources/ProcessorVolume.h"
#include "Resources/ValueFocus.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

// Opacity curves; none stands for a curve that is 1 everywhere.
using Curves = std::vector<std::optional<TransferFunction>>;

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
double LastGradientOf(const std::optional<TransferFunction>& function, const GradientRange& range)
{
  const TransferFunction curve = function.value_or(TransferFunction({}, {}, 1.0));
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
      const TransferFunction& curve = *curves[i];
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
  const Curves& curves = march.frame.material.functions.gradientOpacities;
  Fingerprint inputs = march.frame.material.functions.gradientOpacityInputs;
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

void PreIntegratedTableTexture::Upload(vtkOpenGLRenderWindow* window, PreIntegratedTable table)
{
  this->kept = {};
  this->size = table.size;
  this->texture->SetContext(window);
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->texture->Create2DFromRaw(
    unsigned(table.size), unsigned(table.size), 4, VTK_FLOAT, &table.entries.front().x);
}

void PreIntegratedTableTexture::Keep(vtkWindow* window, PreIntegratedTable table)
{
  this->Release(window);
  this->kept = std::move(table);
}

void PreIntegratedTableTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->size = 0;
  this->kept = {};
}

void OpticalTableTexture::SetTables(vtkWindow* window, std::vector<OpticalTable> newTables)
{
  this->ReleaseTexture(window);
  this->tables = std::move(newTables);
  this->visibleValues.clear();
  for (const OpticalTable& table : this->tables)
  {
    this->visibleValues.push_back(varimarch::VisibleValues(table));
  }
}

void OpticalTableTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->Bytes() == 0)
  {
    this->UploadBehind(window, {});
  }
}

void OpticalTableTexture::UploadRows(vtkOpenGLRenderWindow* window, const TexelMapping& mapping)
{
  if (this->Bytes() > 0)
  {
    return;
  }
  std::vector<glm::vec4> rows;
  std::size_t first = this->tables.size();
  for (const OpticalTable& table : this->tables)
  {
    const double last = double(table.entries.size() - 1);
    const IndexInTable index = IndexOf(table, last, mapping.scale, mapping.offset);
    rows.emplace_back(index.scale, index.bias, double(first), last);
    first += table.entries.size();
  }
  this->UploadBehind(window, std::move(rows));
}

void OpticalTableTexture::UploadBehind(
  vtkOpenGLRenderWindow* window, std::vector<glm::vec4> entries)
{
  for (const OpticalTable& table : this->tables)
  {
    entries.insert(entries.end(), table.entries.begin(), table.entries.end());
  }
  this->texture.Upload(window, entries);
}

std::array<double, 2> OpticalTableTexture::VisibleValuesOfAny() const
{
  std::array<double, 2> any = this->visibleValues.front();
  for (const std::array<double, 2>& values : this->visibleValues)
  {
    any = { std::min(any[0], values[0]), std::max(any[1], values[1]) };
  }
  return any;
}

std::size_t OpticalTableTexture::FirstEntryOf(std::size_t table) const
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < table; ++i)
  {
    first += this->tables[i].entries.size();
  }
  return first;
}

void OpticalTableTexture::Release(vtkWindow* window)
{
  this->ReleaseTexture(window);
  this->tables = { OpticalTable() };
}

namespace
{

// A side of a pre-integrated table has this many entries between two nodes of the transfer
// function, but at least these. A smaller table fits better into the processor's caches.
constexpr double PreIntegratedPerGap = 64.0;
constexpr std::size_t FewestPreIntegrated = 256;

std::size_t PreIntegratedEntries(const VolumeMarch& march, const OpticalTable& table)
{
  const TransferFunction& function = march.frame.material.functions.first;
  const double range = table.lastValue - table.firstValue;
  std::size_t side = function.IsPiecewiseLinear() ? FewestPreIntegrated : MostPreIntegratedValues;
  while (side < MostPreIntegratedValues &&
    side * function.SmallestNodeGap() < PreIntegratedPerGap * range)
  {
    side *= 2;
  }
  side /= march.plan.hasSmallTable ? 2 : 1;
  return side * side;
}

// The table of isosurfaces. Each has two entries: its colour and optical depth, and its isovalue.
std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame, const TexelMapping& mapping)
{
  const TransferFunction& transferFunction = *frame.material.functions.ofIsosurfaces;
  std::vector<glm::vec4> entries;
  for (double isovalue : frame.material.isovalues)
  {
    const double depth = -std::log1p(-transferFunction.Opacity(isovalue));
    entries.emplace_back(transferFunction.Color(isovalue), std::min(depth, 100.0));
    entries.emplace_back(mapping.LimitedTexelOf(isovalue));
  }
  return entries;
}

}

void MaterialResources::Update(const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  this->UpdateOpticalTable(march, texels);
  this->mergesValues =
    march.plan.marcher == Marcher::Device && varimarch::MergesValues(march.frame, texels);
  this->gradientOpacity.Update(march, texels);
  this->UpdateLights(march);
  this->UpdateIsosurfaces(march, texels);
}

void MaterialResources::UpdateOpticalTable(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  const Fingerprint& inputs = march.frame.material.functions.tableInputs;
  if (this->tableOfTexels != texels || this->tableInputs != inputs)
  {
    this->opticalTable.SetTables(march.frame.view.window, this->BuildTables(march, texels));
    this->tableOfTexels = texels; // they have the range that the table spans
    this->tableInputs = inputs;
    ++this->tableBuilds;
  }
  this->twoValues.Update(march.frame.view.window, march.plan.marcher);
  if (march.plan.marcher == Marcher::Processor)
  {
    this->opticalTable.ReleaseTexture(march.frame.view.window);
  }
  else if (march.settings.mask == Mask::Labels)
  {
    this->opticalTable.UploadRows(march.frame.view.window, texels.front().mapping);
  }
  else
  {
    this->opticalTable.Upload(march.frame.view.window);
  }
}

std::vector<OpticalTable> MaterialResources::BuildTables(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  this->twoValues.Release(march.frame.view.window);
  // All tables share MostEntries, but each has at least FewestEntries.
  constexpr std::size_t MostEntries = 65536;
  constexpr std::size_t FewestEntries = 256;
  this->materialTables = march.frame.material.functions.ofMaterials;
  const std::size_t entries = std::max(MostEntries / this->materialTables.size(), FewestEntries);
  std::vector<OpticalTable> tables;
  if (march.settings.functionOf != FunctionOf::Value)
  {
    tables.push_back(this->BuildTwoValues(march, texels.front()));
  }
  while (tables.size() < this->materialTables.size())
  {
    const MaterialFunction& table = this->materialTables[tables.size()];
    const ValueRange& range = texels[table.component].resolved;
    tables.push_back(BuildOpticalTable(table.transferFunction, range.lower, range.upper, entries));
  }
  return tables;
}

OpticalTable MaterialResources::BuildTwoValues(const VolumeMarch& march, const ScalarTexels& texels)
{
  const MaterialFunctions& functions = march.frame.material.functions;
  TwoValueTable table = TwoValueTableOf(functions.twoValues);
  OpticalTable bound = UpperBound(
    table, { texels.smallestScalar, texels.largestScalar }, functions.opacityUnitDistancesMm[0]);
  this->twoValuesSize = table.size;
  this->twoValues.Set(march.frame.view.window, std::move(table.entries));
  return bound;
}

double MaterialResources::MostExtinction() const
{
  double most = 0.0;
  for (const OpticalTable& table : this->opticalTable.Tables())
  {
    for (const glm::vec4& entry : table.entries)
    {
      most = std::max(most, double(entry.w));
    }
  }
  return most;
}

bool MaterialResources::MissesCurve() const
{
  const std::vector<OpticalTable>& tables = this->opticalTable.Tables();
  return std::any_of(
    tables.begin(), tables.end(), [](const OpticalTable& table) { return table.missesCurve; });
}

void MaterialResources::UpdatePreIntegrated(const VolumeMarch& march)
{
  if (!UsesPreIntegration(march.settings))
  {
    this->preIntegratedTable.Release(march.frame.view.window);
    this->preIntegratedOfTable = 0;
  }
  else if (this->preIntegratedOfTable != this->tableBuilds ||
    this->preIntegratedIsSmall != march.plan.hasSmallTable ||
    this->preIntegratedTable.IsKept() != (march.plan.marcher == Marcher::Processor))
  {
    const OpticalTable& optical = this->opticalTable.Table();
    PreIntegratedTable table =
      BuildPreIntegratedTable(optical, PreIntegratedEntries(march, optical));
    march.plan.marcher == Marcher::Processor
      ? this->preIntegratedTable.Keep(march.frame.view.window, std::move(table))
      : this->preIntegratedTable.Upload(march.frame.view.window, std::move(table));
    this->preIntegratedOfTable = this->tableBuilds;
    this->preIntegratedIsSmall = march.plan.hasSmallTable;
  }
}

void MaterialResources::UpdateLights(const VolumeMarch& march)
{
  this->lights.Set(march.frame.view.window,
    march.settings.lights || march.settings.shadowsOthers ? march.frame.lights.lamps.texels
                                                          : std::vector<glm::vec4>());
  this->lights.Update(march.frame.view.window, march.plan.marcher);
}

void MaterialResources::UpdateIsosurfaces(
  const VolumeMarch& march, const std::vector<ScalarTexels>& texels)
{
  const TexelMapping mapping = march.plan.marcher == Marcher::Device
    ? texels.front().mapping
    : MappingsForPackets(texels, march.frame.voxels.components).front();
  this->isosurfaces.Set(march.frame.view.window,
    march.settings.blend == Blend::Isosurface ? IsosurfaceEntriesOf(march.frame, mapping)
                                              : std::vector<glm::vec4>());
  this->isosurfaces.Update(march.frame.view.window, march.plan.marcher);
}

VolumeTextures MaterialResources::Textures() const
{
  VolumeTextures textures = {};
  textures.opticalTable.onDevice = this->opticalTable.Texture();
  textures.preIntegratedTable.onDevice = this->preIntegratedTable.Texture();
  textures.twoValueTable = this->twoValues.Texture();
  textures.gradientOpacityTable = this->gradientOpacity.Texture();
  textures.lightTexels = this->lights.Texture();
  textures.isosurfaces = this->isosurfaces.Texture();
  return textures;
}

std::size_t MaterialResources::Bytes() const
{
  return this->opticalTable.Bytes() + this->twoValues.Bytes() + this->gradientOpacity.Bytes() +
    this->lights.Bytes() + this->isosurfaces.Bytes();
}

void MaterialResources::Release(vtkWindow* window)
{
  this->opticalTable.Release(window);
  this->tableOfTexels.clear();
  this->preIntegratedTable.Release(window);
  this->preIntegratedOfTable = 0;
  this->twoValues.Release(window);
  this->gradientOpacity.Release(window);
  this->lights.Release(window);
  this->isosurfaces.Release(window);
}

}
