#ifndef Varimarch_Testing_OverlapScene_h
#define Varimarch_Testing_OverlapScene_h

#include "Core/Geometry/PixelRays.h"
#include "Core/Quality/ImageError.h"
#include "Module/ComponentVolumes.h"

#include <vtkMultiVolume.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <map>
#include <vector>

/// Volumes that overlap, as a program that knows vtkMultiVolume sets them up, and their truth. Seen
/// along -z in parallel projection, 24 mm of the world around its origin.
class OverlapScene
{
public:
  explicit OverlapScene(int size = 32);

  /// The volume of a port. Its property has this look, and interpolates linearly.
  vtkVolume* Add(int port, vtkImageData* image, const Look& look);
  void Remove(int port);

  /// The picture in float: premultiplied RGBA before the background. By a shader, or by the
  /// processor where it can.
  std::vector<float> Draw();
  std::vector<float> DrawByProcessor();

  /// What the sum of all volumes looks like by the reference, with head light where they are
  /// shaded.
  std::vector<float> Truth();
  varimarch::ImageError Error(); ///< the larger of both

  varimarch::PixelRays RaysWorld();
  std::vector<std::string> ShaderParts();

  int size;
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkMultiVolume> several;
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> mapper;

private:
  struct Part
  {
    vtkSmartPointer<vtkImageData> image;
    vtkSmartPointer<vtkVolume> volume;
    Look look;
  };
  std::map<int, Part> parts; ///< by their ports
};

/// An image of doubles over a box of the world around the origin [mm].
vtkSmartPointer<vtkImageData> CenteredImage(
  glm::ivec3 dimensions, glm::dvec3 sizeMm, const std::function<double(glm::dvec3 voxel)>& value);

/// One value everywhere.
vtkSmartPointer<vtkImageData> HomogeneousBox(glm::dvec3 sizeMm);

#endif
