#ifndef Varimarch_Core_Packets_PacketScene_h
#define Varimarch_Core_Packets_PacketScene_h

#include "Core/Geometry/Viewport.h"
#include "Core/Parameters/MarchParameters.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace varimarch
{

/// The types of voxels that packets of rays can read where they are.
enum class VoxelType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Float32,
};

/// How a packet's rays are integrated; see RenderSettings.h and Shaders/March.
enum class PacketRule
{
  Midpoint,
  PreIntegrated,
  MaterialMidpoint, ///< of what depends on gradients too
  MaterialLinear,
  Extreme,
  Isosurfaces,
  Projection,
  Voxels, ///< without interpolation,
  MaterialVoxels,
  ExtremeVoxel,
};

/// What surfaces are lit by.
enum class PacketShading
{
  None,
  HeadLight,
  Lights,
};

/// Pixels of a packet: two rows of four.
constexpr int PacketWidth = 4;
constexpr int PacketHeight = 2;

/// Voxels as their owner keeps them: at least two along each axis, x fastest, fewer than 2^31, all
/// of them finite. Or coefficients of a spline through them, of type Float32, of which a composite
/// or projection is drawn, with at least four along each axis.
struct PacketVolume
{
  const void* voxels;
  VoxelType type;
  bool areOfSpline;
  glm::ivec3 voxelCount;
};

/// OpticalTable, which is of extinctions per mm, or PreIntegratedTable where that is the rule.
struct PacketLook
{
  const glm::vec4* table;
  int lastIndex;           ///< of an entry, along a side
  float indexScale;        ///< value -> index
  float indexOffset;       ///< is value * scale + offset
  glm::vec4 emissionBelow; ///< emission and extinction below the values of a PreIntegratedTable
  glm::vec4 emissionAbove; ///< the same above them
  glm::vec2 visibleValues; ///< only between these does anything absorb
};

/// The look of a component by a table of the parameters.
inline PacketLook LookBy(
  const VolumeParameters& parameters, const glm::vec4* entries, int table, int component)
{
  return { entries, int(parameters.lastTableIndices[table]), parameters.tableScales[table],
    parameters.tableBiases[table], parameters.emissionBelow, parameters.emissionAbove,
    { parameters.visibleLower[component], parameters.visibleUpper[component] } };
}

/// The look of a label, from OpticalTables; as PacketLook.
struct PacketRow
{
  const glm::vec4* table;
  int lastIndex;
  float indexScale;
  float indexOffset;
};

/// A mask of as many voxels as the volume; see Shaders/Mask and Material/Labelled.glsl.
struct PacketMask
{
  const std::uint16_t* texels; ///< content of each voxel, and its LabelReach; null: no mask
  bool isBinary;               ///< true: what is not 0 is drawn; false: the content is a row
  const PacketRow* rows;
};

/// Shaders/Classify/TwoValueTable.glsl, of a value and its gradient.
struct PacketTwoValues
{
  const glm::vec4* entries; ///< x, of the values, fastest; null: the look is of one value
  glm::ivec2 size;          ///< at least two along each axis
};

/// Shaders/Shade and Shaders/Damping.
struct PacketLight
{
  PacketShading shading;
  bool damps;
  const glm::vec4* texels; ///< lights that are not at the eye, as LightTexels has them
};

/// Shaders/GradientOpacity.
struct PacketGradientOpacity
{
  const glm::vec4* factors; ///< from no gradient on, of four components or rows in each entry,
                            ///< table behind table; null: opacity does not depend on the gradient
};

/// Bricks that steps may leave out.
struct PacketSteps
{
  float mostOpticalDepth;     ///< a ray ends behind more
  const std::uint8_t* bricks; ///< of an OpticalField; null: there is nothing to skip
  glm::ivec3 brickCount;
  bool grow;                  ///< true: steps are longer where less than half of the light is left
  const std::uint16_t* noise; ///< BlueNoiseTile, by which rays begin; null: with a whole step
};

/// A maximum or minimum; see Shaders/Step/BrickExtremes.glsl.
struct PacketExtreme
{
  const std::uint16_t* bricks; ///< of BuildExtremeBricks; null: there is nothing to skip
  const std::uint16_t* blocks; ///< of JoinExtremeBricks
  glm::ivec3 blockCount;
  glm::ivec3 brickCount;
  float bricksPerBlock; ///< along a side
};

/// GapField; see Shaders/Gaps/Cells.glsl and Fill.
struct PacketGaps
{
  const std::uint8_t* texels; ///< null: there are no gaps
  glm::ivec3 count;
};

/// Arrays that cut rays off.
struct PacketCuts
{
  bool crops;                  ///< true: some regions are not drawn
  const glm::vec4* planesGrid; ///< dot(plane, (position, 1)) >= 0 is left
  const float* depth;          ///< of opaque geometry, [0, 1], from below; null: there is none
  glm::ivec2 depthPixels;      ///< size of the depth image
  const float* layers;    ///< of each pixel, from below, the first two of four: the depths between
                          ///< which its ray is marched; null: there are no layers
  glm::ivec2 layerPixels; ///< size of the image of layers
};

/// Between which depths something may be visible; see VisibleDepths.
struct PacketDepths
{
  glm::vec3 axisGrid;   ///< that depths are along
  const float* nearest; ///< of each packet, row by row; none: everything may be. Where it is beyond
  const float* farthest; ///< this, nothing is.
  int columns;           ///< of packets
  int left;              ///< the first pixel
  int bottom;
};

/// Pixels are not colours, but places [grid space], with 1 behind them; Shaders/Locate.
struct PacketLocation
{
  float opacity;      ///< that a ray has there for the first time; 0: pixels are colours
  float leastOpacity; ///< the same of those that never have that; 0: of these it is not asked
  bool orExit;        ///< of all others where they end; else 0, as where there is no ray
};

/// Components of a material beside that of its opacity: Shaders/Components/LuminanceOpacity.glsl
/// and Rgba.glsl.
struct PacketColors
{
  const void* voxels[3]; ///< of the volume's type
  int count; ///< 0: colors are the look's; 1: those of this look; 3: the components are colors
  PacketLook look;
};

/// Shaders/Spacing/Uneven.glsl: voxels of a mixture at uneven places.
struct PacketSpacing
{
  const glm::vec4* bins; ///< UnevenAxis::Bins of each axis in turn; null: places are even
  glm::ivec3 firstBins;  ///< of each axis
  glm::ivec3 lastBins;
};

struct PacketScene;

/// A constituent of a mixture: a component of a volume, see Shaders/Material/Components.glsl,
/// or one of several volumes that overlap, see Shaders/Volumes/Next.glsl.
struct PacketConstituent
{
  bool isOfMixture;          ///< false: the scene is no mixture
  const PacketScene* others; ///< of the first constituent: all others, each in its own grid
  int otherCount;
  int component;        ///< whose opacity it is, for what the parameters have of each
  bool isOfSameBricks;  ///< true: another constituent has the same bricks
  PacketDepths visible; ///< between which something of it may be seen
};

/// An image of a volume, or of the first constituent of a mixture: its numbers, and the arrays that
/// they are about. Their owners keep these until the image is marched.
struct PacketScene
{
  RayParameters rays;
  VolumeParameters parameters; ///< of which scalars are values of the data
  PacketVolume volume;
  PacketLook look;
  PacketTwoValues twoValues;
  PacketLight light;
  PacketGradientOpacity gradientOpacity;
  PacketMask mask;
  PacketGaps gaps;
  PacketExtreme extreme;
  const glm::vec4* isosurfaces; ///< two entries each, by ascending isovalue: color and optical
                                ///< depth; the isovalue
  bool isMean;                  ///< of projections: true for a mean, false for a sum
  PacketSteps steps;
  PacketCuts cuts;
  PacketDepths depths;
  PacketLocation location;
  PacketColors colors;   ///< of a mixture
  PacketSpacing spacing; ///< of a mixture
  PacketConstituent constituent;
  PacketRule rule;
};

}

#endif
