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

/// Of two pictures, the larger of each measure.
varimarch::ImageError LargerError(
  const std::vector<float>& one, const std::vector<float>& other, const std::vector<float>& truth);

/// One volume in one window, as any VTK program would set it up, and its truth.
class MapperScene
{
public:
  /// @param window  one that has been drawn to keeps its shaders for the next scene
  explicit MapperScene(vtkImageData* image, int size = 96,
    vtkHeadlessRenderWindow* window = vtkSmartPointer<vtkHeadlessRenderWindow>::New());
  ~MapperScene();
  MapperScene(const MapperScene&) = delete;
  void operator=(const MapperScene&) = delete;

  /// Along -z from 30 mm above 0, in parallel: the picture is `2 * halfMm` high and wide.
  void LookDown(glm::dvec3 focusWorld, double halfMm);

  /// The picture in float: premultiplied RGBA before the background. By a shader, unless the test
  /// sets the mapper otherwise.
  std::vector<float> Draw();

  /// By packets of rays where these can draw it.
  std::vector<float> DrawByProcessor();

  /// The same picture by the reference integrator, shaded when the property is.
  std::vector<float> Truth(double tolerance = 1e-5);

  /// How far Draw and DrawByProcessor are from Truth, whichever is farther.
  varimarch::ImageError Error();

  /// What a point looks like on its way to the eye; positions and rays in the grid.
  using Material = std::function<varimarch::OpticalProperties(glm::dvec3, const varimarch::Ray&)>;

  /// How far they are from the composite of a material, whichever is farther.
  varimarch::ImageError ErrorOf(const Material& material, double tolerance = 1e-4);

  /// The middle pixel of Draw, premultiplied RGBA; that of DrawByProcessor is expected to be it.
  std::array<float, 4> MiddlePixel();

  /// Of the last Draw; none where no shader drew it.
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

/// Of geometry, with light.
vtkSmartPointer<vtkActor> Ball(const double centerWorld[3], double radiusMm);

/// Of all layers of translucent geometry, and of the volume between them.
void UseDepthPeeling(vtkRenderer* renderer);

#endif
