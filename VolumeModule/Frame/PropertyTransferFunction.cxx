#include "Frame/PropertyTransferFunction.h"

#include "Frame/CurveNodes.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace varimarch
{

TransferFunction TransferFunctionOf(vtkVolumeProperty* property, int component)
{
  std::vector<ColorNode> colors = property->GetColorChannels(component) == 1
    ? GrayNodesOf(property->GetGrayTransferFunction(component))
    : NodesOf(property->GetRGBTransferFunction(component));
  return TransferFunction(std::move(colors), NodesOf(property->GetScalarOpacity(component)),
    property->GetScalarOpacityUnitDistance(component));
}

std::vector<int> LabelsOf(vtkVolumeProperty* property)
{
  const std::set<int> labels = property->GetLabelMapLabels();
  return std::vector<int>(labels.begin(), labels.end());
}

TransferFunction LabelTransferFunctionOf(vtkVolumeProperty* property, int label)
{
  const TransferFunction without = TransferFunctionOf(property);
  vtkColorTransferFunction* const color = property->GetLabelColor(label);
  vtkPiecewiseFunction* const opacity = property->GetLabelScalarOpacity(label);
  return TransferFunction(color ? NodesOf(color) : without.Colors(),
    opacity ? NodesOf(opacity) : without.Opacities(), without.OpacityUnitDistanceMm());
}

TransferFunction OpacityCurveOf(vtkPiecewiseFunction* function)
{
  return TransferFunction({}, NodesOf(function), 1.0);
}

std::string MissingFunctionFeatures(vtkVolumeProperty* property, int components)
{
  std::set<std::string> sentences;
  for (int component = 0; component < components; ++component)
  {
    property->GetColorChannels(component) == 1
      ? sentences.insert(MissingFeatures(property->GetGrayTransferFunction(component)))
      : sentences.insert(MissingFeatures(property->GetRGBTransferFunction(component)));
    sentences.insert(MissingFeatures(property->GetScalarOpacity(component)));
    if (property->HasGradientOpacity(component))
    {
      sentences.insert(MissingFeatures(property->GetGradientOpacity(component)));
    }
  }
  for (const int label : LabelsOf(property))
  {
    vtkColorTransferFunction* const color = property->GetLabelColor(label);
    sentences.insert(color ? MissingFeatures(color) : "");
    for (vtkPiecewiseFunction* const curve :
      { property->GetLabelScalarOpacity(label), property->GetLabelGradientOpacity(label) })
    {
      sentences.insert(curve ? MissingFeatures(curve) : "");
    }
  }
  return std::accumulate(sentences.begin(), sentences.end(), std::string());
}

Fingerprint TransferFunctionInputs(vtkVolumeProperty* property, int component)
{
  const bool isGray = property->GetColorChannels(component) == 1;
  if (!isGray)
  {
    // A function with a table of colours makes it when it is asked for one, and is newer then.
    property->GetRGBTransferFunction(component)->Build();
  }
  vtkObject* const color = isGray
    ? static_cast<vtkObject*>(property->GetGrayTransferFunction(component))
    : property->GetRGBTransferFunction(component);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity(component);
  return Fingerprint(color, color->GetMTime(), opacity, opacity->GetMTime(),
    property->GetScalarOpacityUnitDistance(component));
}

}
