#include "Frame/PropertyTransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <set>

namespace varimarch
{

namespace
{

// Samples between two nodes of a colour space other than linear RGB. With this many, linear RGB
// follows the curve to well below the resolution of a display.
constexpr int SamplesBetweenNodes = 64;

// A curve that is not clamped is 0 beyond its ends.
template <class Node>
void StepToNothingAtEnds(std::vector<Node>& nodes, bool clamped)
{
  if (clamped || nodes.empty())
  {
    return;
  }
  nodes.insert(nodes.begin(), Node{ nodes.front().value, {} });
  nodes.push_back(Node{ nodes.back().value, {} });
}

std::vector<OpacityNode> NodesOf(vtkPiecewiseFunction* function)
{
  std::vector<OpacityNode> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // value, opacity, midpoint, sharpness
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], std::clamp(node[1], 0.0, 1.0), { node[2], node[3] } });
  }
  StepToNothingAtEnds(nodes, function->GetClamping());
  return nodes;
}

std::vector<ColorNode> GrayNodesOf(vtkPiecewiseFunction* function)
{
  std::vector<ColorNode> nodes;
  for (const OpacityNode& node : NodesOf(function))
  {
    nodes.push_back({ node.value, glm::dvec3(node.opacity), node.shape });
  }
  return nodes;
}

bool IsLinearRgb(vtkColorTransferFunction* function)
{
  return function->GetColorSpace() == VTK_CTF_RGB && function->GetScale() == VTK_CTF_LINEAR;
}

std::vector<ColorNode> NodesOf(vtkColorTransferFunction* function)
{
  std::vector<ColorNode> nodes;
  const bool exact = IsLinearRgb(function);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // value, r, g, b, midpoint, sharpness
    function->GetNodeValue(i, node);
    if (!exact && i > 0 && node[0] > nodes.back().value)
    {
      const double previous = nodes.back().value;
      for (int sample = 1; sample < SamplesBetweenNodes; ++sample)
      {
        const double value = previous + (node[0] - previous) * sample / SamplesBetweenNodes;
        glm::dvec3 rgb;
        function->GetColor(value, &rgb[0]);
        nodes.push_back({ value, rgb });
      }
    }
    nodes.push_back({ node[0], { node[1], node[2], node[3] },
      exact ? NodeShape{ node[4], node[5] } : NodeShape{} });
  }
  StepToNothingAtEnds(nodes, function->GetClamping());
  return nodes;
}

}

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

Fingerprint TransferFunctionInputs(vtkVolumeProperty* property, int component)
{
  vtkObject* const color = property->GetColorChannels(component) == 1
    ? static_cast<vtkObject*>(property->GetGrayTransferFunction(component))
    : property->GetRGBTransferFunction(component);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity(component);
  return Fingerprint(color, color->GetMTime(), opacity, opacity->GetMTime(),
    property->GetScalarOpacityUnitDistance(component));
}

}
