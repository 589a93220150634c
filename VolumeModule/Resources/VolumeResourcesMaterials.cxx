// The tables of opacities by gradients, and of isosurfaces.

#include "Resources/VolumeResources.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/PropertyTransferFunction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

using Curves = std::vector<vtkPiecewiseFunction*>; ///< none: 1 everywhere

// Of each part, or of each row of labels.
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

// Four curves share the numbers of an entry.
/// @param largest  of each curve, the gradient of the last entry; one for all curves of labels
std::vector<glm::vec4> GradientOpacityEntries(
  const Curves& curves, const std::vector<double>& largest)
{
  const std::size_t groups = (curves.size() + 3) / 4;
  std::vector<glm::vec4> entries(
    groups * VolumeResources::EntriesPerGradientCurve, glm::vec4(1.0f));
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i])
    {
      const TransferFunction curve = OpacityCurveOf(curves[i]);
      const double last = largest[std::min(i, largest.size() - 1)];
      for (int entry = 0; entry < VolumeResources::EntriesPerGradientCurve; ++entry)
      {
        const double gradient = last * entry / (VolumeResources::EntriesPerGradientCurve - 1);
        entries[i / 4 * VolumeResources::EntriesPerGradientCurve + entry][int(i % 4)] =
          float(curve.Opacity(gradient));
      }
    }
  }
  return entries;
}

}

void VolumeResources::UpdateGradientOpacity(const Frame& frame)
{
  if (!frame.settings.gradientOpacity)
  {
    this->gradientOpacity.Release(frame.window);
    this->gradientOpacitySource.clear();
    return;
  }
  std::vector<double> largest;
  const Curves curves = GradientOpacitiesOf(frame.property, frame.settings);
  std::vector<double> source = { double(frame.property->GetMTime()) };
  for (vtkPiecewiseFunction* curve : curves)
  {
    source.push_back(curve ? double(curve->GetMTime()) : 0.0);
  }
  for (int part = 0; part < PartCount(frame.settings); ++part)
  {
    const int component = OpacityComponentOf(frame.settings, part);
    largest.push_back(LargestGradient(this->blocks.TexelsOfComponents()[component]));
  }
  source.insert(source.end(), largest.begin(), largest.end());
  if (this->gradientOpacitySource != source)
  {
    this->gradientOpacity.Set(frame.window, GradientOpacityEntries(curves, largest));
    this->gradientOpacitySource = source;
  }
  this->gradientOpacity.Update(frame.window, frame.marcher);
}

std::vector<glm::vec4> IsosurfaceEntriesOf(const Frame& frame)
{
  const TransferFunction transferFunction =
    TransferFunctionOf(frame.property, frame.surfaceComponent);
  std::vector<glm::vec4> entries;
  for (double isovalue : frame.isovalues)
  {
    const double depth = -std::log1p(-transferFunction.Opacity(isovalue));
    entries.emplace_back(transferFunction.Color(isovalue), std::min(depth, 100.0));
    entries.emplace_back(isovalue);
  }
  return entries;
}

void VolumeResources::UpdateIsosurfaces(const Frame& frame)
{
  if (frame.settings.blend != Blend::Isosurface || frame.marcher == Marcher::Processor)
  {
    this->isosurfaces.Release(frame.window);
    return;
  }
  std::vector<glm::vec4> texels = IsosurfaceEntriesOf(frame);
  const TexelMapping& mapping = this->blocks.Texels().mapping;
  for (std::size_t i = 0; i < frame.isovalues.size(); ++i)
  {
    texels[2 * i + 1].x = float(mapping.LimitedTexelOf(frame.isovalues[i]));
  }
  this->isosurfaces.Upload(frame.window, texels);
}

}
