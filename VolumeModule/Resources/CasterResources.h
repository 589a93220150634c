#ifndef Varimarch_Resources_CasterResources_h
#define Varimarch_Resources_CasterResources_h

#include "Frame/Frame.h"
#include "Resources/FloatTable.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The opaque geometry that casts shadows on a volume, as a TriangleTree, which is made again only
/// when the geometry changes.
class CasterResources
{
public:
  /// @throws std::runtime_error if the device cannot hold so many triangles
  void Update(const Frame& frame, Marcher marcher);

  /// The tree; null without geometry.
  MarchTexture Tree() const { return this->tree.Texture(); }
  /// The places of its triangles in the data.
  const std::vector<SurfaceTriangle>& Sources() const { return this->sources; }
  std::size_t Bytes() const { return this->tree.Bytes(); } ///< Its graphics memory.
  void Release(vtkWindow* window);

private:
  std::vector<double> inputs; ///< The fingerprint of the geometry in the tree.
  FloatTable tree;
  std::vector<SurfaceTriangle> sources;
  std::size_t texelCount = 0;
};

}

#endif
