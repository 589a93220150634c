#ifndef Varimarch_Testing_MapperScene_h
#define Varimarch_Testing_MapperScene_h

#include "Core/Quality/ImageError.h"
#include "Stages/VolumeStage.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

/// Half of the step between two values of a picture with 8 bits.
inline constexpr double HalfByteStep = 0.5 / 255.0;

/// The larger error of two images in each measure.
varimarch::ImageError LargerError(
  const std::vector<float>& one, const std::vector<float>& other, const std::vector<float>& truth);

/// A stage of tests, which draws by shaders unless told otherwise.
class MapperScene : public varimarch::VolumeStage
{
public:
  /// @param window  a window that was rendered to before keeps its shaders for the next scene
  explicit MapperScene(vtkImageData* image, int size = 96,
    vtkHeadlessRenderWindow* window = vtkSmartPointer<vtkHeadlessRenderWindow>::New());

  /// Looks along -z from z = 30 mm in parallel projection; the image is `2 * halfMm` high and wide.
  void LookDown(glm::dvec3 focusWorld, double halfMm);

  /// The image rendered by packets of rays, if they support the scene.
  std::vector<float> DrawByProcessor();

  /// Error of Draw and DrawByProcessor against Truth, whichever is larger.
  varimarch::ImageError Error();

  /// Error of both against the composite of a material, whichever is larger.
  varimarch::ImageError ErrorOf(const Material& material, double tolerance = 1e-4);

  /// The centre pixel of Draw, premultiplied RGBA; expects the same of DrawByProcessor.
  std::array<float, 4> MiddlePixel();

  /// Parts of the last Draw's shader; empty if no shader rendered it.
  std::vector<std::string> ShaderParts();
  bool UsesShaderPart(const std::string& part);

private:
  varimarch::ImageError ErrorTo(const std::vector<float>& truth);
};

/// A function of a scene that draws its image.
using WayToDraw = std::vector<float> (MapperScene::*)();

/// By shaders, and by packets of rays.
inline std::vector<WayToDraw> WaysToDraw()
{
  return { &MapperScene::Draw, &MapperScene::DrawByProcessor };
}

/// A torso phantom with noise: int16, anisotropic, 40 x 36 x 24 voxels.
vtkSmartPointer<vtkImageData> SmallTorso();

/// The same torso as cell data.
vtkSmartPointer<vtkImageData> TorsoOfCells();

/// A lit ball of geometry.
vtkSmartPointer<vtkActor> Ball(const double centerWorld[3], double radiusMm);

/// Peels all layers of translucent geometry, with the volume in between.
void UseDepthPeeling(vtkRenderer* renderer);

#endif
