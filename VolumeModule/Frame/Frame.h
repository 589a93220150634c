#ifndef Varimarch_Frame_Frame_h
#define Varimarch_Frame_Frame_h

#include "Core/Quality/ErrorBudget.h"
#include "Core/Recipe/RenderSettings.h"
#include "Frame/Cuts.h"
#include "Frame/RequestedPass.h"
#include "Frame/SliceSurface.h"
#include "Frame/UserShaderCode.h"
#include "Frame/VolumeGeometry.h"
#include "Frame/VoxelInput.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace varimarch
{

/// Where a frame is drawn. The objects belong to the caller.
struct FrameView
{
  vtkOpenGLRenderWindow* window = nullptr;
  vtkRenderer* renderer = nullptr;
  vtkVolume* prop = nullptr; ///< The prop whose mapper draws; a vtkMultiVolume has several volumes.
  Viewport viewport = {};    ///< The pixels of the framebuffer.
};

/// The look of a volume's values, beside the choices in RenderSettings.
struct MaterialRequest
{
  vtkVolumeProperty* property = nullptr;
  double labelBlend = 0.0;       ///< The weight of the functions of labels, [0, 1].
  std::vector<double> isovalues; ///< The values of isosurfaces, ascending.
  int surfaceComponent = 0;      ///< The component of the array that isosurfaces are drawn of.
  double dampingGradient = 0.0;  ///< Shading fades below it [units of data per mean spacing].
  SliceSurface slice = {};
  std::array<double, 2> averagedRange = {}; ///< The scalars that count in an average.
  /// Colour and extinction [1/mm] of cells without a value.
  glm::dvec4 gapOptical = glm::dvec4(0.0);
};

/// How exact a frame is to be.
struct QualityRequest
{
  ErrorBudget budget;
  bool choosesIntegration = false; ///< True if a trial may choose the integration rule.
  double sampleDistanceMm = 0.0;   ///< The distance of samples where no tolerance chooses it.
  double variationTolerance = 0.0; ///< The scalar field's tolerance; negative: from the range.
  double earlyTerminationTransmittance = 0.0; ///< A ray ends at this transmittance.
};

/// The image that is made of the rays.
struct ImageRequest
{
  glm::dvec2 windowScaleBias = glm::dvec2(1.0, 0.0); ///< Window and level of colours.
  double sampleDistance = 1.0;                       ///< The distance of rays [pixels].
  /// The shortest and the longest distance of rays [pixels] while a user interacts.
  std::array<double, 2> interactiveSampleDistances = { 1.0, 1.0 };
  bool toImages = false;   ///< True if colours and depths go to images, not into the window.
  bool clampDepth = false; ///< True if the image of depths has the back face where rays are clear.
};

/// How images of a scene that stays as it is are accumulated.
struct AccumulationRequest
{
  int mostImages = 0;              ///< The mean is of at most this many; 0: none is kept.
  double longestPartSeconds = 0.0; ///< The time for a part of an image; 0: it is drawn at once.
  std::vector<double> fingerprint; ///< Everything that the image depends on, if any is kept.
};

/// The means that may be used to draw a frame.
struct DeviceRequest
{
  std::size_t mostMemoryBytes = 0;  ///< The graphics memory that may be used; 0: all there is.
  bool mayMarchOnProcessor = false; ///< True if packets may march where OpenGL is software.
};

/// A request: one volume in one renderer, or the first of several that overlap. BuildFrame checks
/// the input of a mapper and collects here everything that an image depends on, as plain data.
/// Nothing is decided here about how the rays are marched, and nothing changes afterwards: those
/// decisions are in MarchPlan.
struct Frame
{
  FrameView view;
  VoxelInput voxels;
  VolumeGeometry geometry;
  Cuts cuts;
  RenderSettings settings; ///< The choices of the recipe that the request makes.
  MaterialRequest material;
  QualityRequest quality;
  ImageRequest image;
  AccumulationRequest accumulation;
  RequestedPass pass;
  UserShaderCode userCode;
  DeviceRequest device;

  /// The volumes that overlap with this one in the same image. View, image, pass and plan are those
  /// of the first volume; input, material, geometry and settings are their own.
  std::vector<Frame> others;
};

}

#endif
