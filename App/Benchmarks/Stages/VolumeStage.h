#ifndef Varimarch_Benchmarks_VolumeStage_h
#define Varimarch_Benchmarks_VolumeStage_h

#include "Core/Reference/ReferenceScene.h"
#include "Frame/VolumeGeometry.h"

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

#include <functional>
#include <vector>

namespace varimarch
{

enum class MapperKind;

/// One volume in one window, set up as by any VTK program, with its true image. It is for scenes
/// that need more than a Scene of App/Scene can say; tests and measurements have it in common.
class VolumeStage
{
public:
  /// @param size    height and width of the image [pixels]
  /// @param window  a window that was rendered to before keeps its shaders for the next stage
  VolumeStage(vtkImageData* image, int size, vtkHeadlessRenderWindow* window);
  ~VolumeStage();
  VolumeStage(const VolumeStage&) = delete;
  void operator=(const VolumeStage&) = delete;

  /// The image in float: premultiplied RGBA without the background.
  std::vector<float> Draw();

  /// Lets another mapper draw, with all settings of `mapper` that it has too. Later changes of
  /// `mapper` do not reach it.
  void UseMapper(MapperKind kind);

  /// The image of the reference integrator for one component, shaded if the property is.
  std::vector<float> Truth(double tolerance = 1e-5, int component = 0);

  /// Optical properties that the eye sees at a position; positions and rays are in grid space.
  using Material = std::function<OpticalProperties(glm::dvec3, const Ray&)>;

  /// The composite of a material by the reference integrator.
  std::vector<float> TruthOf(const Material& material, double tolerance = 1e-4);

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
  VolumeGeometry ReferenceGeometry();
  std::vector<float> DrawReferenceOf(const ReferenceScene& scene, double tolerance);
};

}

#endif
