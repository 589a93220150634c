#ifndef Varimarch_Viewer_LookEditing_h
#define Varimarch_Viewer_LookEditing_h

#include "Scene/Scene.h"

#include <set>

namespace varimarch
{

/// How a transfer function is edited, without a widget: every function takes a look and returns the
/// changed one. Whatever is asked for, nodes stay sorted, opacities in [0, 1], and both curves keep
/// a node.
///
/// A colour node at the value of an opacity node is *tied* to it: they are one point to the user,
/// and move together. Where a step has two nodes of each kind, the first are tied and the second.

enum class NodeKind
{
  Opacity,
  Color,
};

/// A node of a look.
struct NodeId
{
  NodeKind kind;
  int index; ///< in Look::opacities or Look::colors
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

bool Exists(const Look& look, const NodeId& node);
double ValueOf(const Look& look, const NodeId& node);
NodeShape ShapeOf(const Look& look, const NodeId& node);

/// Whether both have the same curves.
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

/// A new opacity node, with a colour node of the colour that was there, unless one is at the value.
Insertion InsertPoint(const Look& look, double value, double opacity);

/// A new colour node of the colour that was there.
Insertion InsertColor(const Look& look, double value);

/// Moves nodes and those tied to them along the values, all by the same amount, as far as the
/// nodes that stay let them; and the opacity nodes among `nodes` along the opacities.
Look MoveNodes(const Look& look, const NodeSet& nodes, double valueShift, double opacityShift);

/// Removes nodes, and with an opacity node the colours tied to it; of each curve one node stays.
Look RemoveNodes(const Look& look, const NodeSet& nodes);

/// Moves a node and those tied to it to a value, or as near as the nodes that stay let them.
Look SetValue(const Look& look, const NodeId& node, double value);

/// @param node  an opacity node
Look SetOpacity(const Look& look, const NodeId& node, double opacity);

/// An opacity node without a colour of its own gets one.
Look SetColor(const Look& look, const NodeId& node, const glm::dvec3& rgb);

/// How the node's curve runs from it to the next node.
Look SetShape(const Look& look, const NodeId& node, const NodeShape& shape);

/// Moves all values away from a fixed one, or towards it.
/// @param factor  > 0
Look ScaleLook(const Look& look, double factor, double fixedValue);

}

#endif
