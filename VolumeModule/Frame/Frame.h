#ifndef Varimarch_Frame_Frame_h
#define Varimarch_Frame_Frame_h

#include "Core/Recipe/RenderSettings.h"
#include "Frame/Cuts.h"
#include "Frame/RequestedPass.h"
#include "Frame/SliceSurface.h"
#include "Frame/UserShaderCode.h"
#include "Frame/VolumeGeometry.h"
#include "Frame/VoxelInput.h"

#include "vtkType.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace varimarch
{

/// What is to be drawn: one volume in one renderer, or the first of several that overlap, checked,
/// with every choice made.
struct Frame
{
  vtkOpenGLRenderWindow* window;
  vtkRenderer* renderer;
  vtkVolumeProperty* property;
  vtkDataArray* scalars;
  VoxelComponents components; ///< what of the scalars is drawn
  vtkMTimeType scalarsTime;
  VolumeGeometry geometry;
  std::vector<UnevenAxis> axes; ///< of a rectilinear grid; none of an image
  Blanking blanking;
  Cuts cuts; ///< what of it is drawn
  Viewport viewport;
  RenderSettings settings;
  MaskVoxels mask;        ///< where the settings have one
  double labelPart;       ///< of the transfer functions of labels, [0, 1]
  double errorTolerance;  ///< of a premultiplied channel; > 0: chooses the sample distance,
  bool chooseIntegration; ///< and the rule of integration if asked
  double sampleDistanceMm;
  double fieldError;         ///< that homogeneous bricks may add to a premultiplied channel
  double variationTolerance; ///< of the scalar field; negative: chosen from the range
  double earlyTerminationTransmittance;
  std::vector<double> isovalues; ///< of isosurfaces; ascending
  int surfaceComponent = 0;      ///< whose values they are of
  double dampingGradient = 0.0;  ///< [units of data per mean spacing]
  SliceSurface slice;
  std::array<double, 2> averagedRange; ///< the scalars that count in an average
  glm::dvec4 gapOptical;               ///< colour and extinction [1/mm] of cells that have no value
  std::size_t mostMemoryBytes;         ///< of the graphics device; 0: what it has
  bool triesPreIntegration;            ///< there is memory for its table
  glm::dvec2 windowScaleBias;          ///< of the picture's colours
  double imageSampleDistance;          ///< of rays [pixels]
  int mostAccumulated = 0;             ///< pictures of a scene that stays as it is; 0: none is kept
  double longestPartSeconds = 0.0;     ///< of one that is kept; 0: it is drawn at once
  std::vector<double> sceneNumbers;    ///< all of the scene's, which are known where any is kept
  glm::dvec2 rayOffsetPixels = glm::dvec2(0.0); ///< of a ray, from the middle of its pixel
  bool addsUp = false;                          ///< to what is there
  vtkVolume* volume;
  VolumePass volumePass;
  UserShaderCode userCode;
  bool toImages;                    ///< draw these, not into the window
  bool mayMarchByProcessor = false; ///< where OpenGL is drawn by it too
  Marcher marcher = Marcher::Device;
  bool clampDepth; ///< of the image of depths, where nothing is visible

  /// Volumes that overlap with this one, in the same picture: of each what is its own.
  std::vector<Frame> others;
};

}

#endif
