#ifndef Varimarch_Viewer_LookEditing_h
#define Varimarch_Viewer_LookEditing_h

#include "Scene/Model/Scene.h"

#include <set>

namespace varimarch
{

/// Edits of a transfer function, independent of widgets: every function takes a look and returns
/// the changed one. Nodes stay sorted, opacities stay in [0, 1], and each curve keeps at least one
/// node. A look without colours is a plain curve. For looks with Blend::Isosurface, the nodes are
/// the isosurfaces, and curves and colours are left alone.
///
/// A colour node at the value of an opacity node is *tied* to it: the user sees one point, and both
/// move together. At a step with two nodes of each kind, the first ones are tied, and so are the
/// second ones.

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

/// @param node  an opacity node or an isosurface
double OpacityOf(const Look& look, const NodeId& node);

/// The displayed colour of a node.
glm::dvec3 ColorOf(const Look& look, const NodeId& node);

/// Shape of the curve at a node; linear for an isosurface, which has no curve.
NodeShape ShapeOf(const Look& look, const NodeId& node);

/// True if both looks have the same nodes.
bool SameCurves(const Look& a, const Look& b);

TransferFunction FunctionOf(const Look& look);

NodeSet AllNodes(const Look& look);

/// The nodes with those tied to them.
NodeSet WithTied(const Look& look, const NodeSet& nodes);

struct Insertion
{
  Look look;
  NodeId node; ///< the new node
};

/// Adds an opacity node and, unless there is one at its value, a colour node of the current colour;
/// or adds an isosurface. A curve is constant beyond its ends. A visible node added beyond a
/// transparent end therefore comes with a transparent node, so that the values in between stay
/// transparent.
/// @param longestRamp  largest distance between the two [units of the data], > 0; it is shorter if
///                     the end is nearer
Insertion InsertPoint(const Look& look, double value, double opacity, double longestRamp);

/// Moves a value as close to another as the curve's neighbouring nodes of that other value allow.
double WithinNeighbors(const Look& look, double between, double value);

/// Adds an isosurface to a look that has none, at half of the curve's largest opacity.
Look WithSurface(const Look& look);

/// Adds a colour node of the current colour.
Insertion InsertColor(const Look& look, double value);

/// Moves nodes and those tied to them along the values, all by the same amount, as far as the fixed
/// nodes allow; and moves the opacity nodes among `nodes` along the opacities.
Look MoveNodes(const Look& look, const NodeSet& nodes, double valueShift, double opacityShift);

/// Removes nodes, and the colours tied to removed opacity nodes. Each curve keeps one node. If a
/// transparent end is removed, the new end gets a transparent node, as in InsertPoint.
/// @param longestRamp  see InsertPoint
Look RemoveNodes(const Look& look, const NodeSet& nodes, double longestRamp);

/// Moves a node and those tied to it to a value, as far as the fixed nodes allow.
Look SetValue(const Look& look, const NodeId& node, double value);

/// @param node  an opacity node or an isosurface
Look SetOpacity(const Look& look, const NodeId& node, double opacity);

/// Sets the colour of a node. An opacity node without a tied colour node gets one.
Look SetColor(const Look& look, const NodeId& node, const glm::dvec3& rgb);

/// Sets the shape of a curve between a node and the next one. Isosurfaces have no curve.
Look SetShape(const Look& look, const NodeId& node, const NodeShape& shape);

/// Scales all values about a fixed one.
/// @param factor  > 0
Look ScaleLook(const Look& look, double factor, double fixedValue);

}

#endif
