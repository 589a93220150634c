#ifndef Varimarch_Scene_Scene_h
#define Varimarch_Scene_Scene_h

#include "Core/Recipe/RenderSettings.h"
#include "Scene/Model/SceneLook.h"
#include "Scene/Slices/SliceAxes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace varimarch
{

/// How the slices of a slab combine into one image.
enum class SlabBlend
{
  Maximum,
  Minimum,
  Mean,
};

/// How slices show the volumes over the first one.
enum class SliceFusion
{
  Blend,        ///< mixed with the first volume
  Checkerboard, ///< in every other square
};

/// The viewer's slices through the volume, along the patient's axes or turned about the crosshair.
struct SliceSettings
{
  std::optional<std::array<double, 3>>
    crosshairMm; ///< world space, LPS; empty: the middle of the volume
  std::optional<std::array<double, 2>>
    windowLevel;       ///< units of the data; empty: of the file, otherwise of the histogram
  double slabMm = 0.0; ///< >= 0; 0: a single slice
  SlabBlend slabBlend = SlabBlend::Maximum;
  SliceFusion fusion = SliceFusion::Blend;
  double fusionOpacity = 0.5; ///< part of the volumes over the first one in a blend, [0, 1]
  SliceTurn turn = {};
  /// Turns the lines across a curve about it, in the view that straightens the volume along it.
  double curveTurnDegrees = 0.0;
};

/// Measurements and annotations; MeasureKinds.h says what each has.
enum class MeasureKind
{
  Distance,
  Angle,     ///< between two arms from a vertex
  CobbAngle, ///< between two lines anywhere
  Box,       ///< along the volume's axes, with statistics of its voxels
  Ellipse,   ///< in a plane, with statistics
  Freehand,  ///< an outline in a plane, with statistics
  Curve,     ///< a smooth line, along which the volume can be straightened
  Arrow,     ///< with words at its tail
  Text,
};

/// A measurement or an annotation, drawn over the image. World space, LPS.
struct Measure
{
  MeasureKind kind;
  /// Distance, box: both ends. Angle: an end, the vertex, the other end. Cobb angle: both ends of
  /// the first line, then of the second. Ellipse: the middle, and the ends of two conjugate
  /// half-diameters. Freehand: the outline. Curve: the points it passes through. Arrow: the tail
  /// and the tip. Text: its place.
  std::vector<std::array<double, 3>> pointsMm;
  std::string name = {}; ///< the words of an arrow or a text; may be empty
  bool visible = true;
};

/// Far more than anybody measures by hand, and as many as older files can have.
constexpr std::size_t MostMeasures = 3000;

/// Points of an outline or a curve. Screens have fewer pixels along an edge.
constexpr std::size_t MostMeasurePoints = 10000;

/// Layout of a raw file, which the file itself does not record.
struct RawLayout
{
  std::array<int, 3> dimensions = {}; ///< voxels along each axis, x fastest
  std::string type = "uint8";         ///< one of RawTypeNames()
  std::array<double, 3> spacingMm = { 1.0, 1.0, 1.0 };
  bool bigEndian = false;
  std::int64_t headerBytes = 0; ///< size of the header before the first voxel, >= 0
};

/// Kinds of volume, levels and channels of a file are at most these.
constexpr int LargestKind = 99999;
constexpr int LargestLevel = 99;
constexpr int LargestChannel = 99999;

struct FileSource
{
  std::string path;             ///< a file, or a folder with a DICOM series
  std::optional<RawLayout> raw; ///< layout of a file without a header; otherwise empty
  std::string series = {};      ///< which of several DICOM series, as named by vtkVolumeFileReader
  /// True resamples tilted or unevenly spaced slices on an even grid, false keeps them as scanned;
  /// empty resamples those that would be drawn elsewhere than they were scanned.
  std::optional<bool> rectified = {};
  /// Memory that the program may use [MB]: larger voxels stay in their file; 0: the machine's.
  double memoryMegabytes = 0.0;
  /// The level of a file with several, the finest of which is 0; empty for the finest that fits in
  /// half of the free memory or can stay in its chunks.
  std::optional<int> level = {};
  /// A channel of a file with several, counted from 0; empty for all of two to four that can be
  /// read as a whole, or else the first.
  std::optional<int> channel = {};
  int time = 0;                           ///< which of several times, counted from 0
  std::optional<double> timeSeconds = {}; ///< if given, the time nearest to this one is read
  bool filesAreTimes = false;             ///< as vtkVolumeFileReader::SetFilesAreTimes
  int kind = 0; ///< the kind of volume in a DICOM series, counted from 1; 0: the first
};

enum class ProceduralKind
{
  Shells,        ///< nested spherical shells
  MarschnerLobb, ///< the classic test signal for reconstruction
  Torso,         ///< a CT of a torso
  Checkerboard,  ///< voxels that all differ from their neighbours
  Ramp,          ///< values that rise linearly
};

/// A volume that is computed: see ProceduralVolume.h.
struct ProceduralSource
{
  ProceduralKind kind = ProceduralKind::Shells;
  std::array<int, 3> dimensions = { 128, 128, 128 }; ///< each from 2 to LargestProceduralSide
  unsigned seed = 1; ///< seed of the noise, for kinds that have noise
};

constexpr int LargestProceduralSide = 1024;

using VolumeSource = std::variant<FileSource, ProceduralSource>;

/// Viewing direction in the patient's terms. World space is LPS:
/// +x left, +y posterior, +z superior.
enum class View
{
  Automatic, ///< the face of a thin stack, otherwise anterior
  Anterior,  ///< the eye is in front of the patient and looks at the face
  Posterior,
  Left, ///< the eye is at the patient's left
  Right,
  Superior,
  Inferior,
};

/// Pose of a camera that was moved by hand. World space, LPS.
struct CameraPose
{
  std::array<double, 3> positionMm;
  std::array<double, 3> focalPointMm;
  std::array<double, 3> viewUp;
  double parallelScaleMm; ///< half the height of the image, > 0; parallel projection only
};

struct Camera
{
  View view = View::Automatic;
  double azimuthDegrees = 0.0;   ///< turns the eye about the vertical of the image
  double elevationDegrees = 0.0; ///< then raises the eye, (-90, 90)
  double zoom = 1.0;             ///< > 0; at 1 the volume's box just fits the image
  bool parallel = false;
  double viewAngleDegrees = 30.0; ///< vertical, (0, 180); perspective projection only
  std::optional<CameraPose> pose; ///< replaces view, azimuth, elevation and zoom
  /// Distances from the eye between which the volume is visible [mm], 0 < first < second. Empty:
  /// all of it.
  std::optional<std::array<double, 2>> clippingRangeMm = {};
};

/// The place that a light shines from.
enum class LightKind
{
  Head,        ///< the eye
  Camera,      ///< far away, in a direction that turns with the camera
  Directional, ///< far away, in a direction that is fixed in the patient
  Positional,  ///< a point in the patient
};

/// A light on shaded volumes.
struct SceneLight
{
  LightKind kind = LightKind::Head;
  /// Vector towards the light, of any length > 0. Camera: to the right, upwards and towards the
  /// eye. Directional: world space, LPS.
  std::array<double, 3> direction = { 0.0, 0.0, 1.0 };
  std::array<double, 3> positionMm = {};         ///< place of a positional light; world space, LPS
  std::array<double, 3> rgb = { 1.0, 1.0, 1.0 }; ///< each in [0, 1]
  double intensity = 1.0;                        ///< factor of the colour, > 0
  double softnessDegrees = 0.0; ///< half the angle of its cone, [0, 60]; not of a head light
};

/// Keeps the side of the plane that the normal points to. World space, LPS.
struct CutPlane
{
  std::array<double, 3> pointMm;
  std::array<double, 3> normal; ///< any length > 0
};

/// An outline drawn on the image that cuts through the whole depth of the volume.
struct ScissorsCut
{
  Camera camera; ///< camera of the image that the outline was drawn on; has a pose
  /// Points of the outline, at least three, measured from the centre of the image in units of half
  /// its height, to the right and upwards. Self-intersections follow the even-odd rule.
  std::vector<std::array<double, 2>> outline;
  bool keepsInside = false; ///< true removes the outside, false the inside
};

/// The cuts that leave part of the volume visible.
struct SceneCuts
{
  /// Kept fraction of the volume along each axis: first x, last x, first y, ... 0 is the first
  /// voxel, 1 the last.
  std::array<double, 6> box = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  std::vector<CutPlane> planes;
  std::vector<ScissorsCut> scissors;
  bool bodyOnly = false; ///< leaves out the table and all else beside the body, see BodyMask.h
  /// Depth to which the face is cut away [mm], see BodyMask.h; 0: it stays.
  double faceDepthMm = 0.0;
};

constexpr double UsualFaceDepthMm = 15.0;

/// True if the cuts need a mask.
inline bool NeedMask(const SceneCuts& cuts)
{
  return cuts.bodyOnly || cuts.faceDepthMm > 0.0 || !cuts.scissors.empty();
}

/// A view that can be marked.
enum class KeyView
{
  Volume,
  Axial,
  Coronal,
  Sagittal,
};

/// A view that the user has marked to be shown in reports.
struct KeyImage
{
  KeyView view;
  std::string name = {}; ///< may be empty
  SliceSettings slices;  ///< as they were
  Camera camera;
  std::optional<int> time = {}; ///< time of the first volume, from 0; empty if it has only one
};

/// Far more than a report is read with.
constexpr std::size_t MostKeyImages = 100;

/// A rigid motion of a volume away from its patient coordinates: it is turned about the middle of
/// its box, about x, then y, then z, and then moved. World space, LPS.
struct Placement
{
  std::array<double, 3> turnDegrees = {};
  std::array<double, 3> moveMm = {};

  bool operator==(const Placement& other) const
  {
    return this->turnDegrees == other.turnDegrees && this->moveMm == other.moveMm;
  }
};

/// The colours of a volume in slices, from the smallest to the largest value that they show.
enum class SliceColors
{
  Gray,
  Hot, ///< black, red, yellow, white: for PET
  Green,
};

/// A region of a label map, such as an organ: the voxels of one value.
struct Segment
{
  int value;            ///< value of its voxels in the file, not 0
  std::string name;     ///< may be empty
  glm::dvec3 rgb;       ///< [0, 1]
  bool visible = true;  ///< false draws its voxels as the look does
  double opacity = 1.0; ///< opacity of its mean thickness, [0, 1]
};

/// A segmentation that is drawn over a volume; see LabelMap.h.
struct SceneLabels
{
  std::string path;        ///< a file, or a folder with DICOM series
  std::string series = {}; ///< as in FileSource; empty: the first segmentation
  /// Appearance of segments, by their values. Segments of the file that are missing here look as
  /// the file says.
  std::vector<Segment> segments = {};
};

/// A volume that is drawn over the first one, in the same space.
struct OverlaidVolume
{
  VolumeSource source;
  Look look;
  std::string name = {}; ///< may be empty
  Placement placement = {};
  bool visible = true;
  double opacity = 1.0; ///< factor of the opacities of the look, and of the part in slices, [0, 1]
  SliceColors sliceColors = SliceColors::Gray;
  std::optional<std::array<double, 2>> windowLevel = {}; ///< as in SliceSettings
  std::optional<SceneLabels> labels = {};                ///< on the grid of this volume
};

/// Together with the first volume. Graphics cards limit a program to about 16 textures.
constexpr std::size_t MostVolumes = 4;

/// The level of a volume whose voxels stayed in their file, in the order of
/// vtkVariationFieldVolumeMapper.
enum class VolumeLevel
{
  Voxels,
  Coarse,
  Automatic, ///< coarse while somebody interacts
  Refined,   ///< coarse where the image allows it
};

/// The values between the voxels.
enum class Interpolation
{
  Nearest, ///< voxels are boxes
  Linear,
  Cubic, ///< a spline; isosurfaces are linear, and so are VTK's mappers
};

struct RenderOptions
{
  std::optional<double> sampleDistanceMm; ///< > 0; empty: the mapper chooses
  Acceleration acceleration = Acceleration::OpticalField;
  std::optional<Integration> integration;   ///< for composites; empty: the mapper chooses
  double errorTolerance = 1.0 / 64.0;       ///< [0, 1]; used if the mapper chooses the distance
  std::optional<double> variationTolerance; ///< units of the data; empty: the mapper chooses
  double earlyTerminationTransmittance = 1.0 / 1024; ///< [0, 1); used for an error tolerance of 0
  Interpolation interpolation = Interpolation::Linear;
  VolumeLevel level = VolumeLevel::Automatic;
  bool jitter = false; ///< offsets the samples of each ray by blue noise
  /// Sample distance in units of the smallest spacing, > 0; replaces sampleDistanceMm.
  std::optional<double> sampleDistanceVoxels = {};
  int mostSteps = 0;            ///< sample distances after which a ray ends; 0: no limit
  double firstDistanceMm = 0.0; ///< distance from the eye at which rays begin, >= 0
  bool fromBehind = false;      ///< composites are added up from the back; not in scene files
  bool storedGradients = false; ///< gradients are kept in a texture; not in scene files

  bool HasSampleDistance() const { return this->sampleDistanceMm || this->sampleDistanceVoxels; }
};

/// The mapper that renders a scene. Not part of the scene, since all mappers should agree.
enum class MapperKind
{
  Varimarch,        ///< vtkVariationFieldVolumeMapper
  VarimarchShaders, ///< the same with ProcessorMarching off
  VtkGpu,           ///< vtkOpenGLGPUVolumeRayCastMapper
  VtkCpu,           ///< vtkFixedPointVolumeRayCastMapper
};

inline bool IsOurs(MapperKind kind)
{
  return kind == MapperKind::Varimarch || kind == MapperKind::VarimarchShaders;
}

/// Light that matter scatters: vtkVariationFieldVolumeMapper::VolumetricScatteringBlending.
struct Scattering
{
  double blending = 0.0;   ///< [0, 2]; 0: off
  double anisotropy = 0.0; ///< [-0.99, 0.99]
  double reach = 0.0;      ///< [0, 1]

  bool operator==(const Scattering& other) const
  {
    return this->blending == other.blending && this->anisotropy == other.anisotropy &&
      this->reach == other.reach;
  }
};

/// Ambient occlusion: vtkVariationFieldVolumeMapper::AmbientOcclusion.
struct Occlusion
{
  double strength = 0.0; ///< [0, 1]; 0: off
  double reachMm = 0.0;  ///< 0: 16 times the smallest distance between voxels

  bool operator==(const Occlusion& other) const
  {
    return this->strength == other.strength && this->reachMm == other.reachMm;
  }
};

/// The light of a scene, see Scene.
struct Lighting
{
  std::vector<SceneLight> lights = {};
  double shadows = 0.0;
  Scattering scattering = {};
  Occlusion occlusion = {};
};

/// A look with further settings of a scene. Empty settings keep the scene's own.
struct Preset
{
  Look look;
  std::optional<double> errorTolerance = {}; ///< see RenderOptions
  std::optional<std::array<double, 3>> background = {};
  std::optional<Lighting> light = {}; ///< that suits the look; a scene takes it only on request
};

/// Everything that a rendered image depends on, as plain data. SceneFile reads and writes it, and
/// ScenePipeline renders it.
struct Scene
{
  VolumeSource volume;
  Look look;
  std::vector<SceneLight> lights; ///< empty: a white light at the eye
  /// Strength of the shadows that volumes cast on themselves and on each other, [0, 1]; 0: none.
  /// See vtkVariationFieldVolumeMapper::ShadowStrength.
  double shadows = 0.0;
  Scattering scattering;
  Occlusion occlusion;
  Camera camera;
  SceneCuts cuts;
  SliceSettings slices;
  std::vector<Measure> measures;
  std::vector<KeyImage> keyImages;
  std::optional<SceneLabels> labels;
  std::vector<OverlaidVolume> overlays; ///< from the lowest to the uppermost in slices
  RenderOptions render;
  std::array<int, 2> size = { 512, 512 }; ///< image size [pixels]
  std::array<double, 3> background = { 0.0, 0.0, 0.0 };
};

// The volumes of a scene by their numbers: 0 is the first, i the overlay i - 1.

inline int VolumeCount(const Scene& scene)
{
  return 1 + int(scene.overlays.size());
}

inline const std::optional<SceneLabels>& SceneLabelsOf(const Scene& scene, int volume)
{
  return volume == 0 ? scene.labels : scene.overlays[volume - 1].labels;
}

inline std::optional<SceneLabels>& SceneLabelsOf(Scene& scene, int volume)
{
  return volume == 0 ? scene.labels : scene.overlays[volume - 1].labels;
}

inline const VolumeSource& VolumeSourceOf(const Scene& scene, int volume)
{
  return volume == 0 ? scene.volume : scene.overlays[volume - 1].source;
}

/// The first volume is always at its own place.
inline Placement PlacementOf(const Scene& scene, int volume)
{
  return volume == 0 ? Placement() : scene.overlays[volume - 1].placement;
}

}

#endif
