#ifndef Varimarch_Scene_Scene_h
#define Varimarch_Scene_Scene_h

#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/RenderSettings.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace varimarch
{

/// How the bytes of a raw file are to be read; a raw file does not say.
struct RawLayout
{
  std::array<int, 3> dimensions = {}; ///< voxels along each axis, x fastest
  std::string type = "uint8";         ///< one of RawTypeNames()
  std::array<double, 3> spacingMm = { 1.0, 1.0, 1.0 };
  bool bigEndian = false;
  std::int64_t headerBytes = 0; ///< before the first voxel, >= 0
};

struct FileSource
{
  std::string path;             ///< a file, or a folder with a DICOM series
  std::optional<RawLayout> raw; ///< only for files without a header
  std::string series = {};      ///< one of several DICOM series, as vtkVolumeFileReader names it
  bool rectified = false; ///< whether slices that were tilted or lie unevenly are resampled evenly
};

enum class ProceduralKind
{
  Shells,        ///< nested spherical shells
  MarschnerLobb, ///< the classic test signal for reconstruction
  Torso,         ///< a CT of a torso
};

/// A volume that is computed: see ProceduralVolume.h.
struct ProceduralSource
{
  ProceduralKind kind = ProceduralKind::Shells;
  std::array<int, 3> dimensions = { 128, 128, 128 }; ///< each from 2 to LargestProceduralSide
  unsigned seed = 1;                                 ///< of the noise, where there is any
};

constexpr int LargestProceduralSide = 1024;

using VolumeSource = std::variant<FileSource, ProceduralSource>;

/// What the values of a look's nodes mean.
enum class Domain
{
  Data,     ///< units of the data, such as Hounsfield units
  Relative, ///< 0 is the data's 1st percentile, 1 its 99.9th: for MR, which has no units
};

/// Blinn-Phong coefficients, as vtkVolumeProperty has them.
struct Shading
{
  bool enabled = true;
  double ambient = 0.2;        ///< [0, 1]
  double diffuse = 0.8;        ///< [0, 1]
  double specular = 0.2;       ///< [0, 1]
  double specularPower = 16.0; ///< >= 1
};

/// Of the blending that draws surfaces of equal value.
struct Isosurface
{
  double value;
  glm::dvec3 rgb;       ///< [0, 1]
  double opacity = 1.0; ///< of the surface, however thick what is behind it, [0, 1]
};

/// How values are seen: the transfer function and the light.
struct Look
{
  std::string name;        ///< of the preset it came from; may be empty
  std::string description; ///< one line for people; may be empty
  Domain domain = Domain::Data;
  std::vector<ColorNode> colors;      ///< sorted by value, at least one
  std::vector<OpacityNode> opacities; ///< sorted by value, at least one
  double opacityUnitDistanceMm = 1.0; ///< > 0
  /// Factors of the opacity by the magnitude of the gradient [units of the value per mm], of a
  /// composite; sorted by it, empty: the gradient has no say.
  std::vector<OpacityNode> gradientOpacities;
  Shading shading;
  Blend blend = Blend::Composite;
  std::vector<Isosurface> isosurfaces; ///< sorted by value, for that blending at least one
  /// The first and the last value that counts in an average; empty: all do.
  std::optional<std::array<double, 2>> averagedRange;
};

/// A look, and what else a picture should be like; what is empty stays as it was.
struct Preset
{
  Look look;
  std::optional<double> errorTolerance = {}; ///< as in RenderOptions
  std::optional<std::array<double, 3>> background = {};
};

/// Where the eye is, in the patient's terms. World space is LPS: +x left, +y posterior,
/// +z superior.
enum class View
{
  Anterior, ///< looks at the face: the eye is in front of the patient
  Posterior,
  Left, ///< the eye is at the patient's left
  Right,
  Superior,
  Inferior,
};

/// A camera that was moved by hand. World space, LPS.
struct CameraPose
{
  std::array<double, 3> positionMm;
  std::array<double, 3> focalPointMm;
  std::array<double, 3> viewUp;
  double parallelScaleMm; ///< half the height of the picture, > 0; parallel only
};

struct Camera
{
  View view = View::Anterior;
  double azimuthDegrees = 0.0;   ///< turns the eye about the vertical of the picture
  double elevationDegrees = 0.0; ///< then lifts it, (-90, 90)
  double zoom = 1.0;             ///< > 0; at 1 the volume's box just fits the picture
  bool parallel = false;
  double viewAngleDegrees = 30.0; ///< vertical, (0, 180); perspective only
  std::optional<CameraPose> pose; ///< in place of view, azimuth, elevation and zoom
};

/// What lies on the side that the normal points to stays. World space, LPS.
struct CutPlane
{
  std::array<double, 3> pointMm;
  std::array<double, 3> normal; ///< of any length > 0
};

/// An outline that was drawn over a picture, and cuts through the depth of the volume.
struct ScissorsCut
{
  Camera camera; ///< of the picture, with a pose
  /// Around the outline, from the middle of the picture in halves of its height: to the right,
  /// upwards. At least three points; where it crosses itself, the even-odd rule holds.
  std::vector<std::array<double, 2>> outline;
  bool keepsInside = false; ///< what is outside goes; else what is inside
};

/// What of a volume is left to see.
struct SceneCuts
{
  /// From where to where along each axis of the volume: x first, x last, y ..., 0 is the first
  /// voxel, 1 the last.
  std::array<double, 6> box = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  std::vector<CutPlane> planes;
  std::vector<ScissorsCut> scissors;
};

/// How a slab of several slices becomes one picture.
enum class SlabBlend
{
  Maximum,
  Minimum,
  Mean,
};

/// Slices through the volume along the patient's axes, as the viewer has them beside the picture.
struct SliceSettings
{
  std::optional<std::array<double, 3>> crosshairMm; ///< world space, LPS; empty: the middle
  std::optional<std::array<double, 2>> windowLevel; ///< units of the data; empty: from the data
  double slabMm = 0.0;                              ///< >= 0; 0: a single slice
  SlabBlend slabBlend = SlabBlend::Maximum;
};

// What the user has measured, written over the picture. World space, LPS; names may be empty.

struct Distance
{
  std::array<double, 3> fromMm;
  std::array<double, 3> toMm;
  std::string name = {};
};

struct Angle
{
  std::array<double, 3> fromMm;
  std::array<double, 3> vertexMm; ///< where the angle is
  std::array<double, 3> toMm;
  std::string name = {};
};

/// A box along the volume's axes, of whose voxels there are statistics.
struct MeasuredBox
{
  std::array<double, 3> fromMm; ///< a corner, and the one opposite to it
  std::array<double, 3> toMm;
  std::string name = {};
};

struct RenderOptions
{
  std::optional<double> sampleDistanceMm; ///< > 0; empty: the mapper chooses
  Acceleration acceleration = Acceleration::OpticalField;
  std::optional<Integration> integration;   ///< of a composite; empty: the mapper chooses
  double errorTolerance = 1.0 / 64.0;       ///< [0, 1]; for a sample distance that it chooses
  std::optional<double> variationTolerance; ///< units of the data; empty: mapper chooses
  double earlyTerminationTransmittance = 1.0 / 1024; ///< [0, 1)
};

/// Who draws a scene: not part of it, since all should draw the same.
enum class MapperKind
{
  Varimarch,        ///< vtkVariationFieldVolumeMapper
  VarimarchShaders, ///< the same, without ProcessorMarching
  VtkGpu,           ///< vtkOpenGLGPUVolumeRayCastMapper
  VtkCpu,           ///< vtkFixedPointVolumeRayCastMapper
};

inline bool IsOurs(MapperKind kind)
{
  return kind == MapperKind::Varimarch || kind == MapperKind::VarimarchShaders;
}

/// Everything a picture depends on, as plain data. SceneFile reads and writes it, ScenePipeline
/// draws it.
struct Scene
{
  VolumeSource volume;
  Look look;
  Camera camera;
  SceneCuts cuts;
  SliceSettings slices;
  std::vector<Distance> distances;
  std::vector<Angle> angles;
  std::vector<MeasuredBox> boxes;
  RenderOptions render;
  std::array<int, 2> size = { 512, 512 }; ///< of the picture [pixels]
  std::array<double, 3> background = { 0.0, 0.0, 0.0 };
};

}

#endif
