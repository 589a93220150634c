#ifndef Varimarch_Viewer_LookEditing_h
#define Varimarch_Viewer_LookEditing_h

#include "Scene/Scene.h"

#include <set>

namespace varimarch
{

/// How a transfer function is edited, without a widget: every function takes a look and returns the
/// changed one. Whatever is asked for, nodes stay sorted, opacities in [0, 1], and both curves keep
/// a node. A look without colours is a curve alone. Of a look that is blended as isosurfaces, these
/// are the nodes, and curves and colours rest.
///
/// A colour node at the value of an opacity node is *tied* to it: they are one point to the user,
/// and move together. Where a step has two nodes of each kind, the first are tied and the second.

enum class NodeKind
{
  Opacity,
  Color,
  Surface,
};

/// A node of a look.
struct NodeId
{
  NodeKind kind;
  int index; ///< in Look::opacities, Look::colors or Look::isosurfaces
};

inline bool operator<(const NodeId& a, const NodeId& b)
{
  return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
}

inline bool operator==(const NodeId& a, const NodeId& b)
{
  return a.kind == b.kind && a.index == b.index;
}

using NodeSet = std::set<NodeId>;

double ValueOf(const Look& look, const NodeId& node);

/// @param node  has one, and so is none of colour
double OpacityOf(const Look& look, const NodeId& node);

/// What a node looks like.
glm::dvec3 ColorOf(const Look& look, const NodeId& node);

/// Straight, of a surface, which has none.
NodeShape ShapeOf(const Look& look, const NodeId& node);

/// Whether both have the same nodes.
bool SameCurves(const Look& a, const Look& b);

TransferFunction FunctionOf(const Look& look);

NodeSet AllNodes(const Look& look);

/// The nodes, and those that move with them.
NodeSet WithTied(const Look& look, const NodeSet& nodes);

struct Insertion
{
  Look look;
  NodeId node; ///< the new one
};

/// A new opacity node, with a colour node of the colour that was there, unless one is at the value;
/// or a new isosurface. Beyond its ends a curve goes on as it ends: a node that is to be seen
/// beyond an end that is dark comes with a dark one, so that what was dark does not come to light.
/// @param longestRamp  from the one to the other [units of the data], > 0; it is shorter where the
///                     end is nearer
Insertion InsertPoint(const Look& look, double value, double opacity, double longestRamp);

/// A value as near to another as the curve's nodes around that one let it.
double WithinNeighbors(const Look& look, double between, double value);

/// The look with an isosurface, where it has none: where the curve is half as opaque as it gets.
Look WithSurface(const Look& look);

/// A new colour node of the colour that was there.
Insertion InsertColor(const Look& look, double value);

/// Moves nodes and those tied to them along the values, all by the same amount, as far as the
/// nodes that stay let them; and the opacity nodes among `nodes` along the opacities.
Look MoveNodes(const Look& look, const NodeSet& nodes, double valueShift, double opacityShift);

/// Removes nodes, and with an opacity node the colours tied to it; of each curve one node stays.
/// Where a dark end goes, the new end comes with a dark node, as in InsertPoint.
/// @param longestRamp  as of InsertPoint
Look RemoveNodes(const Look& look, const NodeSet& nodes, double longestRamp);

/// Moves a node and those tied to it to a value, or as near as the nodes that stay let them.
Look SetValue(const Look& look, const NodeId& node, double value);

/// @param node  has an opacity
Look SetOpacity(const Look& look, const NodeId& node, double opacity);

/// An opacity node without a colour of its own gets one.
Look SetColor(const Look& look, const NodeId& node, const glm::dvec3& rgb);

/// How the node's curve, which is none of surfaces, runs from it to the next node.
Look SetShape(const Look& look, const NodeId& node, const NodeShape& shape);

/// Moves all values away from a fixed one, or towards it.
/// @param factor  > 0
Look ScaleLook(const Look& look, double factor, double fixedValue);

}

#endif
