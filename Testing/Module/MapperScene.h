#ifndef Varimarch_Testing_MapperScene_h
#define Varimarch_Testing_MapperScene_h

#include "Core/Quality/ImageError.h"
#include "Core/Reference/ReferenceScene.h"
#include "Frame/VolumeGeometry.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

/// Half of the step between two values of a picture with 8 bits.
inline constexpr double HalfByteStep = 0.5 / 255.0;

/// The larger error of two images in each measure.
varimarch::ImageError LargerError(
  const std::vector<float>& one, const std::vector<float>& other, const std::vector<float>& truth);

/// One volume in one window, set up as by any VTK program, with its true image.
class MapperScene
{
public:
  /// @param window  a window that was rendered to before keeps its shaders for the next scene
  explicit MapperScene(vtkImageData* image, int size = 96,
    vtkHeadlessRenderWindow* window = vtkSmartPointer<vtkHeadlessRenderWindow>::New());
  ~MapperScene();
  MapperScene(const MapperScene&) = delete;
  void operator=(const MapperScene&) = delete;

  /// Looks along -z from z = 30 mm in parallel projection; the image is `2 * halfMm` high and wide.
  void LookDown(glm::dvec3 focusWorld, double halfMm);

  /// The image in float: premultiplied RGBA without the background. Rendered by a shader unless the
  /// test sets the mapper otherwise.
  std::vector<float> Draw();

  /// The image rendered by packets of rays, if they support the scene.
  std::vector<float> DrawByProcessor();

  /// The image of the reference integrator for one component, shaded if the property is.
  std::vector<float> Truth(double tolerance = 1e-5, int component = 0);

  /// Error of Draw and DrawByProcessor against Truth, whichever is larger.
  varimarch::ImageError Error();

  /// Optical properties that the eye sees at a position; positions and rays are in grid space.
  using Material = std::function<varimarch::OpticalProperties(glm::dvec3, const varimarch::Ray&)>;

  /// The composite of a material by the reference integrator.
  std::vector<float> TruthOf(const Material& material, double tolerance = 1e-4);

  /// Error of both against the composite of a material, whichever is larger.
  varimarch::ImageError ErrorOf(const Material& material, double tolerance = 1e-4);

  /// The centre pixel of Draw, premultiplied RGBA; expects the same of DrawByProcessor.
  std::array<float, 4> MiddlePixel();

  /// Parts of the last Draw's shader; empty if no shader rendered it.
  std::vector<std::string> ShaderParts();
  bool UsesShaderPart(const std::string& part);

  vtkSmartPointer<vtkImageData> image;
  int size;
  vtkSmartPointer<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;

private:
  bool IsNearest();
  varimarch::VolumeGeometry ReferenceGeometry();
  std::vector<float> DrawReferenceOf(const varimarch::ReferenceScene& scene, double tolerance);
  varimarch::ImageError ErrorTo(const std::vector<float>& truth);
};

/// A torso phantom with noise: int16, anisotropic, 40 x 36 x 24 voxels.
vtkSmartPointer<vtkImageData> SmallTorso();

/// The same torso as cell data.
vtkSmartPointer<vtkImageData> TorsoOfCells();

/// A lit ball of geometry.
vtkSmartPointer<vtkActor> Ball(const double centerWorld[3], double radiusMm);

/// Peels all layers of translucent geometry, with the volume in between.
void UseDepthPeeling(vtkRenderer* renderer);

#endif
