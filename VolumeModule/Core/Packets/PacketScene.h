#ifndef Varimarch_Core_Packets_PacketScene_h
#define Varimarch_Core_Packets_PacketScene_h

#include "Core/Geometry/Viewport.h"

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

/// The rays of a picture: PixelRays in single precision, and where they are marched [grid space].
struct PacketCamera
{
  glm::vec4 startGrid[3];
  glm::vec3 directionGrid[3];
  glm::vec4 nearPlaneGrid;
  glm::vec4 farPlaneGrid;
  glm::mat3 worldFromGrid; ///< directions only
  glm::vec3 boxLowerGrid;
  glm::vec3 boxUpperGrid;
  int pictureWidth; ///< [pixels]
  int pictureHeight;
  glm::vec2 rayOffsetPixels; ///< from the middle of its pixel
};

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
  int lastIndex;     ///< of an entry, along a side
  float indexScale;  ///< value -> index
  float indexOffset; ///< is value * scale + offset
  glm::vec4 below;   ///< of PreIntegratedTable: what is beyond its ends
  glm::vec4 above;
  glm::vec2 visibleValues; ///< only between these does anything absorb
};

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
  const std::uint16_t* texels; ///< of each voxel what it is, and LabelReach; none: there is no mask
  bool isBinary;               ///< only what is not 0 is drawn, else by the row that it is,
  const PacketRow* rows;
  float rowPart;        ///< which counts so much beside row 0, [0, 1]
  float unitDistanceMm; ///< of opacities that are mixed so
};

/// Shaders/Classify/TwoValueTable.glsl, of a value and its gradient.
struct PacketTwoValues
{
  const glm::vec4* entries;    ///< x, of the values, fastest; none: the look is of one value
  glm::ivec2 size;             ///< at least two along each axis
  float placeScale;            ///< value -> place in its range, [0, 1],
  float placeOffset;           ///< is value * scale + offset
  glm::vec3 placesPerGradient; ///< a gradient per voxel -> its length is a place
  float unitDistanceMm;
};

/// Shaders/Shade and Shaders/Damping.
struct PacketLight
{
  PacketShading shading;
  glm::mat3 worldFromGradient;
  glm::vec4 reflectance; ///< coefficients of ambient, diffuse and specular light, specular power
  glm::vec3 diffuse;     ///< colours of the lights at the eye
  glm::vec3 specular;
  glm::vec3 dampingFactors; ///< a gradient per voxel -> parts of that at which light is whole
  bool damps;
  glm::vec3 ambient; ///< from here on of Lights only
  float backsLit;    ///< 1: both sides of a surface are
  glm::vec3 worldOfGridOrigin;
  const glm::vec4* texels; ///< the other lights, as LightTexels has them
  int distantCount;
  int nearCount;
};

/// Shaders/GradientOpacity/Table.glsl.
struct PacketGradientOpacity
{
  const glm::vec4* factors; ///< from no gradient on; or of row 4 n + i of a mask's in number i of
                            ///< the n-th table; none: opacity does not depend on it
  int channel;              ///< the number of an entry that counts, without a mask
  int lastIndex;
  glm::vec3 indicesPerGradient; ///< a gradient per voxel -> its length is an index
  float unitDistanceMm;
};

/// How long the steps are.
struct PacketSteps
{
  float stepMm;
  int mostSegments;
  float mostOpticalDepth;     ///< behind more, a ray ends
  const std::uint8_t* bricks; ///< of an OpticalField; none: there is nothing to skip
  glm::ivec3 brickCount;
  float cellsPerBrick;
  bool grow;                  ///< where less than half of the light is left
  const std::uint16_t* noise; ///< BlueNoiseTile, by which rays begin; none: with a whole step
  int noiseMask;              ///< its size less 1
};

/// A maximum or minimum; see Shaders/Step/BrickExtremes.glsl.
struct PacketExtreme
{
  float sense; ///< 1: a maximum; -1: a minimum, of which all values are negated here
  float best;  ///< that any voxel has
  float opacityUnitDistanceMm;
  const std::uint16_t* bricks; ///< of BuildExtremeBricks; none: there is nothing to skip
  const std::uint16_t* blocks; ///< of JoinExtremeBricks
  glm::ivec3 blockCount;
  float bricksPerBlock; ///< along a side
  glm::ivec3 brickCount;
  float bestOfFirstStep;
  float bestPerStep;
};

/// A mean or a sum; see Shaders/Blend/AverageIntensity.glsl and Additive.glsl.
struct PacketProjection
{
  bool isMean; ///< else a sum
  float smallestValue;
  float grayPerValue;
  float opacityUnitDistanceMm;
  glm::vec2 countedValues; ///< both included
  float mostIntegral;      ///< [mm] behind that, a ray ends
};

/// Shaders/Surface/Isosurfaces.glsl.
struct PacketIsosurfaces
{
  const glm::vec4* entries; ///< two of each, by ascending isovalue: colour and optical depth; that
  int count;
};

/// CroppingRegions.
struct PacketRegions
{
  glm::vec4 planesGrid[6]; ///< of x, y and z, lower and upper: >= 0 beyond it
  int drawn;               ///< bit x + 3 y + 9 z: 0 below, 1 between, 2 above the planes of an axis
};

/// GapField; see Shaders/Gaps/Cells.glsl and Fill.
struct PacketGaps
{
  const std::uint8_t* texels; ///< none: there are no gaps
  glm::ivec3 count;
  float firstGrid;      ///< where cell 0 begins, on each axis
  glm::vec4 gapOptical; ///< colour and extinction [1/mm] of what has no value
};

/// What cuts rays off.
struct PacketCuts
{
  bool crops; ///< only some regions are drawn
  PacketRegions regions;
  const glm::vec4* planesGrid; ///< dot(plane, (position, 1)) >= 0 is left
  int planeCount;
  const float* depth;     ///< of opaque geometry, [0, 1], from below; none: there is none
  glm::ivec2 depthPixels; ///< its size
  glm::vec2 depthPixelsPerPixel;
  const float* layers;    ///< of each pixel of the picture, from below, the first two of four: the
                          ///< depths between which its ray is; none: there are no layers
  glm::vec4 clipDepthRow; ///< rows of clipFromGrid that give clip z and w
  glm::vec4 clipWeightRow;
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
  int count;             ///< 0: colours are the look's; 1: those of this look; 3: they are colours
  PacketLook look;
  float colorPerValue;
};

/// Shaders/Spacing/Uneven.glsl: voxels of a mixture at uneven places.
struct PacketSpacing
{
  const glm::vec4* bins; ///< UnevenAxis::Bins of each axis in turn; none: places are even
  glm::ivec3 firstBins;  ///< of each axis
  glm::ivec3 lastBins;
  glm::vec3 lowerGrid;
  glm::vec3 binsPerGrid;
};

struct PacketScene;

/// A constituent of a mixture: a component of a volume, see Shaders/Material/Components.glsl,
/// or one of several volumes that overlap, see Shaders/Volumes/Next.glsl.
struct PacketConstituent
{
  bool isOfMixture;          ///< else the scene is no mixture
  const PacketScene* others; ///< of the first: all others, each in its own grid
  int otherCount;
  float weight;           ///< that its extinction has in the mixture
  bool isOfSameBricks;    ///< as another constituent, which tells of them
  glm::mat4 gridFromRays; ///< which are in the grid of the first
  glm::vec3 lowerGrid;    ///< of what is drawn of this volume
  glm::vec3 upperGrid;
  PacketDepths visible; ///< between which something of it may be seen
};

/// A picture of a volume, or of the first constituent of a mixture, in plain numbers.
struct PacketScene
{
  PacketCamera camera;
  PacketVolume volume;
  PacketLook look;
  PacketTwoValues twoValues; ///< of materials,
  PacketLight light;         ///< these, and
  PacketGradientOpacity gradientOpacity;
  PacketMask mask;
  PacketGaps gaps;
  PacketExtreme extreme;         ///< where that is the rule,
  PacketIsosurfaces isosurfaces; ///< these,
  PacketProjection projection;   ///< and this
  PacketSteps steps;
  PacketCuts cuts;
  PacketDepths depths;
  PacketLocation location; ///< of a composite or isosurfaces
  PacketColors colors;     ///< of a mixture, as the next
  PacketSpacing spacing;
  PacketConstituent constituent;
  PacketRule rule;
};

}

#endif
