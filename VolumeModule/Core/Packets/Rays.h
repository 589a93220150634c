#ifndef Varimarch_Core_Packets_Rays_h
#define Varimarch_Core_Packets_Rays_h

// The rays of a packet, and the part of them that is marched, with the names of RayMarch.frag.glsl.
// Twin of Clip/Planes.glsl, Depth/SceneGeometry.glsl and Span/Limited.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

#include <cstddef>

namespace varimarch
{

namespace
{

constexpr float Never = 3.0e38f;

/// The rows of pixels in a packet of PacketWidth columns.
constexpr int PacketRows = LaneCount / PacketWidth;

struct PacketRays
{
  Lanes3 originGrid;
  Lanes3 directionGrid; ///< per mm
  Lanes3 inverse;       ///< inverse of the direction, finite
  IntLanes region;      ///< the label of the part that is marched, in a mask
  Lanes enter;          ///< [mm]; equal to the exit for a ray without a part inside
  Lanes exit;
  Lanes wholeEnter; ///< [mm]; the part in the whole box, only if steps are shared
  Lanes wholeExit;
  Lanes opaqueAt; ///< [mm]; the exit if matter is opaque there, else Never

  /// The length of the part of the rays between two places [mm].
  Lanes LengthBetween(Lanes from, Lanes to) const
  {
    return Max(Min(to, this->exit) - Max(from, this->enter), Lanes{});
  }

  Lanes3 At(Lanes t) const { return this->originGrid + t * this->directionGrid; }
};

inline Lanes Affine(float constant, float alongX, float alongY, Lanes x, Lanes y)
{
  return constant + x * alongX + y * alongY;
}

/// @tparam Matrix  of three columns
template <class Matrix>
Lanes3 Transformed(const Matrix& matrix, const Lanes3& a)
{
  const glm::vec3 &x = matrix[0], &y = matrix[1], &z = matrix[2];
  return { a.x * x.x + a.y * y.x + a.z * z.x, a.x * x.y + a.y * y.y + a.z * z.y,
    a.x * x.z + a.y * y.z + a.z * z.z };
}

/// A place in another grid.
inline Lanes3 PlaceIn(const glm::mat4& otherFromGrid, const Lanes3& placeGrid)
{
  const glm::vec4& move = otherFromGrid[3];
  return Transformed(glm::mat3(otherFromGrid), placeGrid) +
    Lanes3{ All(move.x), All(move.y), All(move.z) };
}

/// The same rays in the grid of a volume; t is a length in the world.
inline PacketRays InGridOf(const VolumeParameters& volume, const PacketRays& rays)
{
  PacketRays own = rays;
  own.originGrid = PlaceIn(volume.ownGridFromRays, rays.originGrid);
  own.directionGrid = Transformed(glm::mat3(volume.ownGridFromRays), rays.directionGrid);
  own.inverse = SafeInverse(own.directionGrid);
  return own;
}

/// Keeps the part of rays that is inside a box.
inline void KeepInside(PacketRays& rays, const glm::vec3& lower, const glm::vec3& upper)
{
  const Lanes2 inside = IntersectBox(rays.originGrid, rays.inverse, AllOf3(lower), AllOf3(upper));
  rays.enter = Max(rays.enter, inside.x);
  rays.exit = Min(rays.exit, inside.y);
}

inline Lanes BeyondPlane(const glm::vec4& plane, const Lanes3& position)
{
  return BeyondPlane(AllOf4(plane), position);
}

inline Lanes ApproachToPlane(const glm::vec4& plane, const Lanes3& direction)
{
  return ApproachToPlane(AllOf4(plane), direction);
}

/// Keeps the part beyond a plane, as Shaders/Clip/Planes.glsl does.
inline void KeepBeyond(PacketRays& rays, const glm::vec4& plane)
{
  const Lanes2 kept = CutByPlane({ rays.enter, rays.exit }, BeyondPlane(plane, rays.originGrid),
    ApproachToPlane(plane, rays.directionGrid));
  rays.enter = kept.x;
  rays.exit = kept.y;
}

/// Keeps the part that is marched, as Shaders/Span/Limited.glsl does.
inline void CutToSpan(PacketRays& rays, const PacketScene& scene, Lanes enterWhole)
{
  const RayParameters& p = scene.rays;
  const auto& worldFromGrid = scene.parameters.worldFromGrid;
  const Lanes3 toEye = Transformed(worldFromGrid, AllOf3(p.eyeGrid) - rays.originGrid);
  const Lanes first =
    Dot(toEye, Transformed(worldFromGrid, rays.directionGrid)) + p.firstDistanceMm;
  const Lanes2 spanned = CutToSpan({ rays.enter, rays.exit }, enterWhole, first, All(p.spanMm));
  rays.enter = spanned.x;
  rays.exit = spanned.y;
}

/// The depth at each pixel, some of which may be beyond the image's edges.
inline Lanes DepthsAt(const PacketScene& scene, int x, int y)
{
  const float* const texels = scene.rayTextures.depthTexture.Texels<float>();
  const glm::ivec2& size = scene.cuts.depthPixels;
  const glm::vec2& perPixel = scene.rays.depthPixelsPerPixel;
  float depths[LaneCount];
  const auto within = [](float place, int count)
  { return place < float(count) ? int(place) : count - 1; };
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = within((float(x + lane % PacketWidth) + 0.5f) * perPixel.x, size.x);
    const int row = within((float(y + lane / PacketWidth) + 0.5f) * perPixel.y, size.y);
    depths[lane] = texels[std::ptrdiff_t(row) * size.x + column];
  }
  return LanesAt(depths);
}

/// The t at which rays have a depth of the depth buffer; not finite for rays with a single depth.
inline Lanes AtDepth(const PacketRays& rays, const RayParameters& parameters, Lanes depth)
{
  const Lanes clipDepth = 2.0f * depth - 1.0f;
  const Lanes approach = ApproachToPlane(parameters.clipDepthRow, rays.directionGrid) -
    clipDepth * ApproachToPlane(parameters.clipWeightRow, rays.directionGrid);
  const Lanes beyond = BeyondPlane(parameters.clipDepthRow, rays.originGrid) -
    clipDepth * BeyondPlane(parameters.clipWeightRow, rays.originGrid);
  return -beyond / approach;
}

/// Ends rays at opaque geometry.
inline void CutByDepth(PacketRays& rays, const PacketScene& scene, int x, int y)
{
  const Lanes depth = DepthsAt(scene, x, y);
  const Lanes end = AtDepth(rays, scene.rays, depth);
  const LaneMask ends = LaneMask(depth < 1.0f) & LaneMask(end > -Never) & LaneMask(end < rays.exit);
  rays.exit = Select(ends, end, rays.exit);
}

/// Keeps the part between two layers of translucent geometry, as Shaders/Resume/Peel.glsl does.
inline void CutByLayers(PacketRays& rays, const PacketScene& scene, int x, int y)
{
  float front[LaneCount];
  float back[LaneCount];
  const glm::ivec2 size = scene.cuts.layerPixels;
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = x + lane % PacketWidth;
    const int row = y + lane / PacketWidth;
    const bool isInImage = column < size.x && row < size.y;
    const std::ptrdiff_t pixel = std::ptrdiff_t(row) * size.x + column;
    front[lane] = isInImage ? scene.cuts.layers[4 * pixel] : 0.0f;
    back[lane] = isInImage ? scene.cuts.layers[4 * pixel + 1] : 0.0f;
  }
  const Lanes from = LanesAt(front);
  const Lanes to = LanesAt(back);
  rays.enter = Max(AtDepth(rays, scene.rays, from), rays.enter);
  rays.exit = Min(AtDepth(rays, scene.rays, to), rays.exit);
  rays.exit = Select(LaneMask(from < to), rays.exit, rays.enter);
}

inline int PacketAt(const PacketDepths& depths, int x, int y)
{
  return (y - depths.bottom) / PacketHeight * depths.columns + (x - depths.left) / PacketWidth;
}

/// Keeps the part where something may be visible.
inline void CutByVisible(PacketRays& rays, const PacketDepths& depths, int x, int y)
{
  const int packet = PacketAt(depths, x, y);
  const glm::vec3& axis = depths.axisGrid;
  KeepBeyond(rays, { axis.x, axis.y, axis.z, -depths.nearest[packet] });
  KeepBeyond(rays, { -axis.x, -axis.y, -axis.z, depths.farthest[packet] });
}

/// True if anything may be visible in a packet.
inline bool IsVisible(const PacketDepths& depths, int x, int y)
{
  const int packet = PacketAt(depths, x, y);
  return !depths.nearest || depths.nearest[packet] <= depths.farthest[packet];
}

/// The rays as whole lines.
inline PacketRays LinesOf(const PacketScene& scene, int x, int y)
{
  const RayParameters& parameters = scene.rays;
  const glm::vec2& origin = parameters.viewportOriginPixels;
  const glm::vec2& perPixel = parameters.viewportPixelsInverse;
  const Lanes column = LanesOf([](int lane) { return float(lane % PacketWidth); });
  const Lanes row = LanesOf([](int lane) { return float(lane / PacketWidth); });
  const Lanes viewX = (column + (float(x) + 0.5f - origin.x)) * (2.0f * perPixel.x) - 1.0f;
  const Lanes viewY = (row + (float(y) + 0.5f - origin.y)) * (2.0f * perPixel.y) - 1.0f;
  const shader::vec4* const s = parameters.rayStartGrid;
  const shader::vec3* const d = parameters.rayDirectionGrid;

  PacketRays rays;
  rays.originGrid = (1.0f / Affine(s[0].w, s[1].w, s[2].w, viewX, viewY)) *
    Lanes3{ Affine(s[0].x, s[1].x, s[2].x, viewX, viewY),
      Affine(s[0].y, s[1].y, s[2].y, viewX, viewY), Affine(s[0].z, s[1].z, s[2].z, viewX, viewY) };
  const Lanes3 direction{ Affine(d[0].x, d[1].x, d[2].x, viewX, viewY),
    Affine(d[0].y, d[1].y, d[2].y, viewX, viewY), Affine(d[0].z, d[1].z, d[2].z, viewX, viewY) };
  rays.directionGrid =
    (1.0f / Length(Transformed(scene.parameters.worldFromGrid, direction))) * direction;
  rays.inverse = SafeInverse(rays.directionGrid);
  rays.region = IntLanes{};
  rays.enter = All(-Never);
  rays.exit = All(Never);
  rays.wholeEnter = rays.enter;
  rays.wholeExit = rays.exit;
  rays.opaqueAt = All(Never);
  return rays;
}

/// The part of lines that is inside a box and that all planes leave.
inline PacketRays InsideBox(const PacketScene& scene, const PacketRays& lines,
  const glm::vec3& lowerGrid, const glm::vec3& upperGrid)
{
  PacketRays rays = lines;
  KeepInside(rays, lowerGrid, upperGrid);
  KeepBeyond(rays, scene.rays.nearPlaneGrid);
  KeepBeyond(rays, scene.rays.farPlaneGrid);
  for (int plane = 0; plane < scene.rays.clippingPlaneCount; ++plane)
  {
    KeepBeyond(rays, scene.rayTextures.clippingPlanes[plane]);
  }
  return rays;
}

/// Cuts rays, which are inside a box already, by the span, by geometry and by layers.
inline void CutInside(
  PacketRays& rays, const PacketScene& scene, const PacketRays& lines, int x, int y)
{
  const RayParameters& parameters = scene.rays;
  if (scene.cuts.limitsSpan)
  {
    CutToSpan(rays, scene,
      InsideBox(scene, lines, parameters.wholeLowerGrid, parameters.wholeUpperGrid).enter);
  }
  if (scene.rayTextures.depthTexture)
  {
    CutByDepth(rays, scene, x, y);
  }
  if (scene.cuts.layers)
  {
    CutByLayers(rays, scene, x, y);
  }
}

/// The part of rays in the whole box, and of it that in the box of this part.
inline PacketRays SharedRaysOf(const PacketScene& scene, const PacketRays& lines, int x, int y)
{
  const RayParameters& parameters = scene.rays;
  PacketRays rays = InsideBox(scene, lines, parameters.wholeLowerGrid, parameters.wholeUpperGrid);
  CutInside(rays, scene, lines, x, y);
  rays.wholeEnter = rays.enter;
  rays.wholeExit = rays.exit;
  KeepInside(rays, parameters.boxLowerGrid, parameters.boxUpperGrid);
  return rays;
}

/// The part of rays in the box.
inline PacketRays OwnRaysOf(const PacketScene& scene, const PacketRays& lines, int x, int y)
{
  const RayParameters& parameters = scene.rays;
  PacketRays rays = InsideBox(scene, lines, parameters.boxLowerGrid, parameters.boxUpperGrid);
  CutInside(rays, scene, lines, x, y);
  if (scene.depths.nearest)
  {
    CutByVisible(rays, scene.depths, x, y);
  }
  return rays;
}

/// @param x, y  the first pixel of the packet, in the image
inline PacketRays RaysOf(const PacketScene& scene, int x, int y)
{
  const PacketRays lines = LinesOf(scene, x, y);
  PacketRays rays =
    scene.steps.areShared ? SharedRaysOf(scene, lines, x, y) : OwnRaysOf(scene, lines, x, y);
  const LaneMask inside = LaneMask(rays.enter < rays.exit);
  rays.enter = Select(inside, rays.enter, Lanes{});
  rays.exit = Select(inside, rays.exit, Lanes{});
  rays.wholeEnter = Select(inside, rays.wholeEnter, Lanes{});
  rays.wholeExit = Select(inside, rays.wholeExit, Lanes{});
  return rays;
}

}

}

#endif
