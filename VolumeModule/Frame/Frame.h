#ifndef Varimarch_Frame_Frame_h
#define Varimarch_Frame_Frame_h

#include "Core/Blocks/BlockLevels.h"
#include "Core/Quality/ErrorBudget.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/Cuts.h"
#include "Frame/Fingerprint.h"
#include "Frame/Lights.h"
#include "Frame/MaterialFunctions.h"
#include "Frame/RequestedPass.h"
#include "Frame/ShadowCasters.h"
#include "Frame/SliceSurface.h"
#include "Frame/UserShaderCode.h"
#include "Frame/VolumeGeometry.h"
#include "Frame/VoxelInput.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The window, renderer and pixels that a frame is drawn to, and its camera as it is when the frame
/// is built. The objects belong to the caller. The renderer serves to build further frames of the
/// view, to tell views apart, and to draw VTK's translucent geometry.
struct FrameView
{
  vtkOpenGLRenderWindow* window = nullptr;
  vtkRenderer* renderer = nullptr;
  vtkVolume* prop = nullptr; ///< The prop whose mapper draws; a vtkMultiVolume has several volumes.
  Viewport viewport = {};    ///< The pixels of the framebuffer.
  Viewport inWindow = {}; ///< The same pixels in the window: a pass may have another framebuffer.
  glm::dmat4 clipFromWorld = glm::dmat4(1.0); ///< See ClipFromWorld.
  glm::dvec3 eyeWorld = glm::dvec3(0.0);      ///< The camera's position, in any projection.
  glm::dvec3 forwardWorld = glm::dvec3(0.0);  ///< The camera's direction of projection.
  bool isLeftEye = true;
};

/// The look of a volume's values, apart from the choices in RenderSettings.
struct MaterialRequest
{
  MaterialFunctions functions;
  /// The coefficients of ambient, diffuse and specular light and the specular power of each
  /// component.
  std::array<glm::dvec4, 4> reflectances = {};
  std::array<double, 4> weights = {}; ///< The weights of independent components, [0, 1].
  double clippedScalar = 0.0;         ///< The scalar beyond clipping planes that are surfaces.
  double labelBlend = 0.0;            ///< The weight of the functions of labels, [0, 1].
  std::vector<double> isovalues;      ///< The values of isosurfaces, ascending.
  int surfaceComponent = 0;           ///< The component of the array that has the isosurfaces.
  /// The gradient below which shading fades [units of data per mean spacing].
  double dampingGradient = 0.0;
  double scatteredPart = 0.0; ///< The part of the light that matter scatters, [0, 1].
  double anisotropy = 0.0;    ///< The mean cosine of the angle by which it turns light.
  /// The part of what matter takes from a light that surfaces lack, [0, 1]; scattered light lacks
  /// all of it.
  double surfacesInShadow = 1.0;
  double shadowReachMm = 0.0; ///< The distance beyond which matter casts no shadow.
  double occlusion = 0.0;     ///< The strength of ambient occlusion, [0, 1].
  double occlusionReachMm = 0.0;
  double occluderVoxelMm = 0.0; ///< The smallest spacing of the volumes that occlude.
  double occludersMm = 0.0;     ///< An upper bound of the length of a ray within these volumes.
  SliceSurface slice = {};
  std::array<double, 2> averagedRange = {}; ///< The range of scalars that count in an average.
  /// Colour and extinction [1/mm] of cells without a value.
  glm::dvec4 gapOptical = glm::dvec4(0.0);
};

/// The required accuracy of a frame.
struct QualityRequest
{
  ErrorBudget budget;
  bool choosesIntegration = false; ///< True if a trial may choose the integration rule.
  double sampleDistanceMm = 0.0;   ///< The sample distance, unless a tolerance chooses it.
  double variationTolerance =
    0.0; ///< The tolerance of a field of values; negative: from the range.
  double earlyTerminationTransmittance = 0.0; ///< The transmittance at which a ray ends.
};

/// The part of a ray that is marched, if not all of it in the volume.
struct SpanRequest
{
  double firstDistanceMm = 0.0; ///< The distance from the eye at which rays begin.
  int mostSteps = 0;            ///< The number of sample distances that rays go; 0: no limit.
};

/// The image that is made from the rays.
struct ImageRequest
{
  glm::dvec2 windowScaleBias = glm::dvec2(1.0, 0.0); ///< Window and level of colours.
  double sampleDistance = 1.0;                       ///< The distance between rays [pixels].
  /// The shortest and the longest distance between rays [pixels] while a user interacts.
  std::array<double, 2> interactiveSampleDistances = { 1.0, 1.0 };
  bool toImages = false;   ///< True if colours and depths go to images, not into the window.
  bool clampDepth = false; ///< True if clear rays get the depth of the volume's back face.
};

/// The accumulation of images of a scene that does not change.
struct AccumulationRequest
{
  int mostImages = 0;              ///< The number of images in the mean; 0: no accumulation.
  double longestPartSeconds = 0.0; ///< The time for a part of an image; 0: it is drawn at once.
  Fingerprint fingerprint;         ///< See ImageFingerprint; empty if nothing is accumulated.
};

/// The memory and the processors that may be used to draw a frame.
struct DeviceRequest
{
  std::size_t mostMemoryBytes = 0;  ///< The graphics memory that may be used; 0: no limit.
  std::size_t mostHostBytes = 0;    ///< The memory that the program may use; 0: no limit.
  bool mayMarchOnProcessor = false; ///< True if packets may march when OpenGL is software.
};

/// A request to draw one volume in one renderer, or the first of several that overlap. BuildFrame
/// checks the input of a mapper and collects here everything that an image depends on, as plain
/// data. A frame does not change once it is built; MarchPlan holds the decisions on how its rays
/// are marched.
struct Frame
{
  FrameView view;
  VoxelInput voxels;
  VolumeGeometry geometry;
  Cuts cuts;
  RenderSettings settings; ///< The part of the recipe that the request determines.
  MaterialRequest material;
  SceneLights lights;
  ShadowCasters casters; ///< Only with shadows.
  QualityRequest quality;
  SpanRequest span;
  ImageRequest image;
  AccumulationRequest accumulation;
  RequestedPass pass;
  UserShaderCode userCode;
  DeviceRequest device;
  /// Sentences for the user about numbers of the scene that have no meaning and were replaced.
  std::vector<std::string> replacedNumbers;
  Fingerprint fingerprint; ///< See VolumeFingerprint.
  Fingerprint extinction;  ///< See ExtinctionFingerprint.
  Fingerprint unlit;       ///< See UnlitFingerprint.
  Fingerprint refinement;  ///< See ImageFingerprint; empty unless the image is refined by levels.
  /// Everything in the volumes that overlap, this one among them, that ambient occlusion depends
  /// on; empty without.
  Fingerprint occluders;

  /// The volumes that overlap with this one in the same image. They share view, image, pass and
  /// plan with the first volume, and have input, material, geometry and settings of their own.
  std::vector<Frame> others;

  /// The coarser levels of the volume if they are drawn in some blocks instead of the voxels, from
  /// the finest on: frames of the same look. Only packets draw them; shaders draw the voxels of all
  /// blocks.
  std::vector<Frame> coarser;
  std::shared_ptr<const BlockLevels> blockLevels; ///< null without coarser levels
  int levelRound = 0;    ///< tells the levels of an image from those of others of the same scene
  bool voxelsFit = true; ///< False if the voxels that are drawn may not fit in the memory for them.

  glm::dmat4 ClipFromGrid() const
  {
    return this->view.clipFromWorld * this->geometry.worldFromGrid;
  }
};

}

#endif
