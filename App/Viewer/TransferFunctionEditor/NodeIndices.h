#ifndef Varimarch_Viewer_NodeIndices_h
#define Varimarch_Viewer_NodeIndices_h

#include <algorithm>
#include <utility>
#include <vector>

namespace varimarch
{

/// Index range [first, last) of the nodes at a value. The nodes are sorted.
template <class Node>
std::pair<int, int> IndicesAt(const std::vector<Node>& nodes, double value)
{
  const auto below = [](const Node& node, double limit) { return node.value < limit; };
  const auto above = [](double limit, const Node& node) { return limit < node.value; };
  return { int(std::lower_bound(nodes.begin(), nodes.end(), value, below) - nodes.begin()),
    int(std::upper_bound(nodes.begin(), nodes.end(), value, above) - nodes.begin()) };
}

}

#endif
