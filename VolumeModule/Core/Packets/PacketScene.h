#ifndef Varimarch_Core_Packets_PacketScene_h
#define Varimarch_Core_Packets_PacketScene_h

#include "Core/Blocks/BlockLevels.h"
#include "Core/Fields/LightLattice.h"
#include "Core/Geometry/SphereQuadrature.h"
#include "Core/Geometry/Viewport.h"
#include "Core/Geometry/VoxelType.h"
#include "Core/Parameters/MarchParameters.h"
#include "Core/Parameters/MarchTextures.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <limits>

namespace varimarch
{

/// How a packet's rays are integrated; see RenderSettings.h and Shaders/March.
enum class PacketRule
{
  Midpoint,
  PreIntegrated,
  MaterialMidpoint, ///< midpoints of materials, which depend on gradients too
  MaterialLinear,   ///< linear segments of materials
  Extreme,
  Isosurfaces,
  Projection,
  RangeMean,      ///< the mean of values in a range, from cell to cell
  Voxels,         ///< boxes without interpolation
  MaterialVoxels, ///< boxes whose material depends on gradients too
  ExtremeVoxel,
};

/// The lights of surfaces.
enum class PacketShading
{
  None,
  HeadLight,
  Lights,
};

/// Pixels of a packet: two rows of four.
constexpr int PacketWidth = 4;
constexpr int PacketHeight = 2;

/// True if there are fewer than 2^31 voxels.
inline bool IsIndexedBy32Bits(const glm::ivec3& voxelCount)
{
  const double count = double(voxelCount.x) * voxelCount.y * voxelCount.z;
  return count < double(std::numeric_limits<std::int32_t>::max());
}

/// Voxels as their owner keeps them: at least two along each axis, x fastest, all of them finite.
/// There are fewer than 2^31 in a mixture, or with labels, a mask or gaps. A spline is given by its
/// coefficients, of type Float32, at least four along each axis and fewer than 2^31; it is drawn as
/// a composite or projection.
struct PacketVolume
{
  const void* voxels;
  VoxelType type;
  bool areOfSpline;
  glm::ivec3 voxelCount;
};

/// The entries of an OpticalTable, with extinctions per mm, or of a PreIntegratedTable for that
/// rule.
struct PacketLook
{
  const glm::vec4* table;
  int lastIndex;           ///< index of the last entry along a side
  float indexScale;        ///< value -> index
  float indexOffset;       ///< is value * scale + offset
  glm::vec4 emissionBelow; ///< emission and extinction below the values of a PreIntegratedTable
  glm::vec4 emissionAbove; ///< the same above them
  glm::vec2 visibleValues; ///< values between these may absorb, no others
  const double* sums;      ///< ExtinctionSums of the table; null without light that matter dims
};

/// The look of a component by a table of the parameters.
inline PacketLook LookBy(
  const VolumeParameters& parameters, const glm::vec4* entries, int table, int component)
{
  return { entries, int(parameters.lastTableIndices[table]), parameters.tableScales[table],
    parameters.tableBiases[table], parameters.emissionBelow, parameters.emissionAbove,
    { parameters.visibleLower[component], parameters.visibleUpper[component] }, nullptr };
}

/// The look of a label, from OpticalTables, with members as in PacketLook.
struct PacketRow
{
  const glm::vec4* table;
  int lastIndex;
  float indexScale;
  float indexOffset;
};

/// Lights of a scene that may cast shadows; lights beyond these cast none.
constexpr int MostShadowedLights = 8;

/// How exactly shadows are computed, and where their lattices of light are; see LightLattice.
struct PacketShadows
{
  /// Nodes of the lattice of each light; null: every shadow is a ray.
  std::uint8_t* nodes[MostShadowedLights];
  LatticeShape shape;
  float nodeStepMm; ///< longest segment of the rays that fill nodes
  float agreement;  ///< largest difference between the nodes of a cell that is used
  float tolerance;  ///< error that a shadow may add to a colour; 0: none
  /// Extinction of opaque matter in light [1/mm]. Floats tell places in it apart.
  float mostExtinction = 1e30f;
};

/// Light from all around, as far as matter lets it through: ambient occlusion.
struct PacketSky
{
  float strength;                         ///< (0, 1]; 0: all light arrives everywhere
  float reachMm;                          ///< distance beyond which matter does not count
  glm::vec4 directions[SphereDirections]; ///< SphereQuadrature [grid space per mm], with weights
  std::uint8_t* nodes;                    ///< nodes of its lattice; null: every place is traced
  LatticeShape shape;
  float stepMm;     ///< longest segment of rays
  float nodeStepMm; ///< the same of rays that fill nodes
  float agreement;  ///< largest difference between the nodes of a cell that is used
  float mostDepth;  ///< optical depth beyond which no light is left
};

/// Shaders/Shade and Shaders/Damping.
struct PacketLight
{
  PacketShading shading;
  bool damps;
  bool labels;       ///< labels are lit as their own surfaces
  bool castsShadows; ///< Shaders/Reach; only with lights
  bool scatters;     ///< Shaders/Scatter; only with lights
};

/// Bricks that steps may leave out.
struct PacketSteps
{
  float mostOpticalDepth;     ///< a ray ends beyond this optical depth
  const std::uint8_t* bricks; ///< bricks of an OpticalField; null: there is nothing to skip
  glm::ivec3 brickCount;
  bool grow; ///< true: steps are longer where less than half of the light is left
  /// True: rays take the samples that a march of the whole box takes, of which theirs is a part.
  bool areShared;
};

/// A maximum or minimum; see Shaders/Step/BrickExtremes.glsl.
struct PacketExtreme
{
  const std::uint16_t* bricks; ///< result of BuildExtremeBricks; null: there is nothing to skip
  const std::uint16_t* blocks; ///< result of JoinExtremeBricks
  glm::ivec3 blockCount;
  glm::ivec3 brickCount;
  float bricksPerBlock; ///< bricks along a side of a block
};

/// The values at which matter is opaque, at which rays end; see OpaqueValues.
struct PacketOpaque
{
  static constexpr int MostRanges = 2;
  int count;
  glm::vec2 ranges[MostRanges]; ///< finite; an infinite end is the largest float
  float entry;                  ///< distance of the entries of the table
};

/// Arrays and choices that cut rays off.
struct PacketCuts
{
  bool limitsSpan; ///< true if rays begin at a distance from the eye, or end after some steps
  glm::ivec2 depthPixels; ///< size of the depth image
  /// Four numbers for each pixel, from below; the first two are the depths between which its ray is
  /// marched. Null: there are no layers.
  const float* layers;
  glm::ivec2 layerPixels; ///< size of the image of layers
};

/// The depths between which something may be visible; see VisibleDepths.
struct PacketDepths
{
  glm::vec3 axisGrid;   ///< axis along which depths are measured
  const float* nearest; ///< nearest depth of each packet, row by row; null: all may be visible
  const float*
    farthest;  ///< farthest depth of each packet; less than the nearest: nothing is visible
  int columns; ///< number of packets in a row
  int left;    ///< the first pixel
  int bottom;
};

/// A request for places [grid space], with 1 as fourth number, instead of colours.
struct PacketLocation
{
  float opacity;      ///< opacity that a ray reaches at its place; 0: pixels are colours
  float leastOpacity; ///< opacity for rays that never reach the other one; 0: they have no place
  bool orExit;        ///< true: all other rays have the place where they end; false: 0
};

/// A request for the light that a volume lets through to places [grid space], instead of colours:
/// the parts of four lights, as the four numbers of a pixel.
struct PacketReceivers
{
  const glm::vec4* places; ///< places of the pixels, with 1 as fourth number, or 0 where there
                           ///< is no place; null: pixels are colours
  Viewport pixels;         ///< the pixels that have places
  int firstLight;          ///< the first of the four lights
};

/// The components that give a material its colours: Shaders/Components/LuminanceOpacity.glsl and
/// Rgba.glsl.
struct PacketColors
{
  const void* voxels[3]; ///< voxels of the components, of the volume's type
  int count; ///< 0: colours are the look's; 1: those of this look; 3: the components are colours
  PacketLook look;
};

struct PacketScene;

/// A constituent of a mixture: a component of a volume, see Shaders/Material/Components.glsl,
/// or one of several volumes that overlap, see Shaders/Volumes/Next.glsl.
struct PacketConstituent
{
  bool isOfMixture;          ///< false: the scene is no mixture
  const PacketScene* others; ///< all others, each in its own grid; only for the first constituent
  int otherCount;
  int component;        ///< component of its opacity, which selects its parameters
  bool isOfSameBricks;  ///< true: another constituent has the same bricks
  PacketDepths visible; ///< depths between which it may be visible
};

/// Blocks of a volume that are drawn by coarser levels: BlockLevels. The scenes of all levels have
/// them.
struct PacketLevels
{
  /// The scene of the voxels, and those of the coarser levels, each a volume of the same type in a
  /// grid of its own; null: all blocks are drawn by voxels.
  const PacketScene* const* scenes;
  int count;                  ///< number of the scenes
  glm::mat4 voxelGridFromOwn; ///< from the grid of the scene that has this
  const BlockLevel* ofBlocks; ///< see BlockLevels
  glm::ivec3 blockCount;
  float blockSideGrid; ///< length of a block's side, in voxels
};

/// An image of a volume, or of the first constituent of a mixture: its numbers, and pointers to
/// arrays, whose owners keep them until the image is marched. A texture that is not in memory is of
/// a feature that the image does not have.
struct PacketScene
{
  RayParameters rays;
  RayTextures rayTextures;
  VolumeParameters parameters; ///< scalars are values of the data
  VolumeTextures textures;     ///< without the voxels, bricks and looks of the members below
  PacketVolume volume;
  PacketLook look;
  const PacketRow* labelRows; ///< null: voxels have no labels
  PacketLight light;
  PacketShadows shadows; ///< only if the light casts shadows
  PacketSky sky;
  PacketExtreme extreme;
  PacketOpaque opaque;
  bool isMean; ///< projections: true for a mean, false for a sum
  PacketSteps steps;
  PacketCuts cuts;
  PacketDepths depths;
  PacketLocation location;
  PacketReceivers receivers; ///< only of the first constituent in a mixture
  PacketColors colors;       ///< only in a mixture
  PacketConstituent constituent;
  PacketLevels levels; ///< not in a mixture
  PacketRule rule;
};

}

#endif
