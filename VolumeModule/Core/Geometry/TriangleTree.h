#ifndef Varimarch_Core_Geometry_TriangleTree_h
#define Varimarch_Core_Geometry_TriangleTree_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace varimarch
{

using Triangle = std::array<glm::vec3, 3>;

/// Triangles that move together, and others that do.
using TriangleGroups = std::vector<std::vector<Triangle>>;

/// The triangle that a ray meets first.
struct TriangleHit
{
  float t;              ///< The distance along the ray, in lengths of its direction.
  std::size_t triangle; ///< Its number among those that the tree was made of.
};

/// A tree of boxes over triangles, by which a ray finds whether it meets any. It is made by halving
/// the groups, and the triangles of each group, at the median along the longest side, and is a
/// plain array, which shaders (Casters/Triangles.glsl) and packets of rays (Reach/MeetTriangles.h)
/// walk without a stack. The first node is left for one behind all nodes.
///
/// Two texels for each node, in depth-first order:
/// - its lower corner, and the node to go on with if the ray misses its box;
/// - its upper corner, and the first texel of its triangles, or 0 if it has nodes instead.
/// Then three texels for each triangle: its first corner, and the edges to the second and to the
/// third one. The fourth numbers of the first two are 1 if the node has no further triangle, and
/// the triangle's number.
class TriangleTree
{
public:
  /// The most triangles of a tree: floats count its texels exactly.
  static constexpr std::size_t MostTriangles = std::size_t(1) << 21;

  /// @param groups  triangles in any unit, numbered from the first of the first group on; those
  /// without an area or with a number that is not finite are left out
  /// @throws std::invalid_argument for more than MostTriangles
  explicit TriangleTree(const TriangleGroups& groups = {});

  /// Moves the triangles of a group, whose nodes keep their triangles: much faster than a new tree,
  /// and as good for rays if the triangles stay as near to each other.
  /// @param moved  all triangles of the group
  /// @return false, and the tree stays as it is, if other triangles have an area now
  bool Move(std::size_t group, const std::vector<Triangle>& moved);

  /// The nodes and triangles.
  const std::vector<glm::vec4>& Texels() const { return this->texels; }

private:
  struct Numbered
  {
    Triangle corners;
    std::size_t number;
  };

  /// A group in the order of the tree.
  struct Sorted
  {
    std::size_t group;
    std::vector<Numbered> triangles;
    glm::vec3 middle;
  };

  /// The parts of the tree that belong to a group.
  struct Group
  {
    std::size_t firstNumber;
    std::size_t firstNode;
    std::size_t endNode;
    std::size_t firstTexel; ///< that of its triangles, which are as many as its numbers or fewer
    std::size_t endTexel;
  };

  static Sorted SortedOf(std::size_t group, std::vector<Numbered> triangles);
  static void Sort(Numbered* begin, Numbered* end);
  std::vector<Sorted> SortedGroups(const TriangleGroups& all);
  void AddGroups(Sorted* begin, Sorted* end);
  std::size_t AddNode(float firstTriangle);
  void CloseNode(std::size_t node);
  void AddNodes(const Numbered* begin, const Numbered* end);
  void PlaceTriangles();
  void FitBox(std::size_t node);
  void FitBoxes(std::size_t firstNode, std::size_t endNode);

  std::vector<glm::vec4> texels;    ///< The nodes, and behind them the triangles.
  std::vector<glm::vec4> triangles; ///< The texels of the triangles while the tree is made.
  std::vector<Group> groups;
  std::vector<std::size_t> nodesOfGroups; ///< The nodes above those of groups, from the root on.
};

/// The triangle that a ray meets first between its origin and its exit.
/// @param tree  the texels of a TriangleTree
std::optional<TriangleHit> NearestTriangle(
  const glm::vec4* tree, glm::vec3 origin, glm::vec3 direction, float exit);

}

#endif
