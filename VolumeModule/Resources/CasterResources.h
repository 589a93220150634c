#ifndef Varimarch_Resources_CasterResources_h
#define Varimarch_Resources_CasterResources_h

#include "Core/Geometry/TriangleTree.h"
#include "Core/Parameters/MarchTextures.h"
#include "Frame/CasterTriangles.h"
#include "Frame/Frame.h"
#include "Resources/FloatBufferTexture.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace varimarch
{

/// The opaque geometry that casts shadows on a volume, as a TriangleTree. The tree is made again
/// when the data of the geometry change. Where only matrices do, the triangles of these surfaces
/// are moved in it.
class CasterResources
{
public:
  /// @throws std::runtime_error if the device cannot hold so many triangles
  void Update(const Frame& frame, Marcher marcher);

  /// The tree; null without geometry.
  MarchTexture Tree() const;
  /// The places of its triangles in the data.
  const std::vector<SurfaceTriangle>& Sources() const { return this->sources; }
  std::size_t Bytes() const { return this->texture.Bytes(); } ///< Its graphics memory.
  void Release(vtkWindow* window);

private:
  bool Move(const ShadowCasters& casters);
  void Make(const ShadowCasters& casters);

  ShadowCasters made; ///< The geometry in the tree; its data may be gone.
  std::optional<TriangleTree> tree;
  FloatBufferTexture texture; ///< The tree for the device.
  std::vector<SurfaceTriangle> sources;
};

}

#endif
