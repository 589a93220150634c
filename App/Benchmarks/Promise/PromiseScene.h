#ifndef Varimarch_Promise_PromiseScene_h
#define Varimarch_Promise_PromiseScene_h

#include "Benchmarks/Stages/Dice.h"
#include "JudgeScene.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkLight;
class vtkMultiVolume;
class vtkOpenGLRenderWindow;
class vtkVariationFieldGPUVolumeRayCastMapper;

namespace varimarch
{

/// The value of each voxel, about [0, 1].
using PromiseContent = std::function<double(glm::ivec3 voxel)>;

using PromiseNodes = std::vector<std::pair<double, double>>;

/// A small scene of VTK's objects for the judge, put together step by step by a kind. All choices
/// are those of the dice.
class PromiseScene
{
public:
  PromiseScene(std::uint64_t seed, vtkOpenGLRenderWindow* window);
  ~PromiseScene();
  PromiseScene(const PromiseScene&) = delete;
  void operator=(const PromiseScene&) = delete;

  Dice dice;

  ///@{ @name The volume
  /// Adds one. More than one are those of a vtkMultiVolume, with which the plugin's class draws.
  void AddVolume(
    glm::ivec3 size, glm::dvec3 spacingMm, const PromiseContent& content, int type = VTK_FLOAT);
  void Replace(int volume, const PromiseContent& content); ///< other data in place
  vtkVolumeProperty* Property(int volume = 0)
  {
    return this->volumes[std::size_t(volume)]->GetProperty();
  }
  vtkImageData* Image(int volume = 0) { return this->images[std::size_t(volume)]; }
  vtkVolume* Volume(int volume = 0) { return this->volumes[std::size_t(volume)]; }
  /// Sets opacities over values in [0, 1], and colours by chance.
  void SetLook(const PromiseNodes& opacities, double unitVoxels = 1.0, int volume = 0);
  /// The value that stands for a content.
  double ValueOf(double content, int volume = 0) const
  {
    const std::array<double, 2>& scale = this->valueScales[std::size_t(volume)];
    return scale[0] + scale[1] * content;
  }
  void Turn(int volume = 0);  ///< rotates and moves the volume
  void Shear(int volume = 0); ///< by a matrix of the user
  ///@}

  ///@{ @name Light
  void Shade(double specular = 0.0);
  vtkLight* AddHeadLight();
  vtkLight* AddDistantLight();
  vtkLight* AddLamp(bool outside = true);
  ///@}

  ///@{ @name Cuts, masks and geometry
  void AddClippingPlane();
  void Crop();
  void SetMask(bool isBinary);
  /// Adds a box or a ball, unlit.
  /// @param atVoxels  its centre, relative to the middle of the volume, in diagonals
  vtkActor* AddGeometry(glm::dvec3 atDiagonals, double sizeDiagonals, bool isSeen);
  ///@}

  ///@{ @name The view
  void LookFrom(glm::dvec3 direction, double distanceDiagonals = 1.6);
  void LookFromAnywhere();
  void LookInParallel(glm::dvec3 direction, double halfDiagonals);
  ///@}

  /// Renders once, as a program does, and returns premultiplied RGBA floats.
  std::vector<float> Draw();
  /// The same without volumes.
  std::vector<float> DrawBehind();
  JudgedObjects Objects();
  vtkVariationFieldVolumeMapper* Mapper() { return this->mapper; }
  vtkRenderer* Renderer() { return this->renderer; }
  double DiagonalMm();
  glm::dvec3 MiddleMm();
  glm::dvec3 Direction(); ///< a unit vector by chance

  int side = 32;                            ///< height and width of the picture [pixels]
  std::vector<std::function<void()>> edits; ///< edits that follow the first picture

private:
  void Show();

  vtkOpenGLRenderWindow* window;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkVariationFieldVolumeMapper> mapper;
  vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper> adapter; ///< draws several volumes
  vtkSmartPointer<vtkMultiVolume> several;
  std::vector<vtkSmartPointer<vtkImageData>> images;
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  std::vector<std::array<double, 2>> valueScales; ///< value = first + second * content
  std::vector<vtkSmartPointer<vtkActor>> actors;
};

}

#endif
